// Topics within one process, without DDS: what is written waits at its readers when write() returns, and a match
// is made when an end is. A run in lock-step carries its own samples so, in a tenth of the time.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "runtime/dds/participant.hpp"

namespace bw::dds {

/// Ends match by topic, type and QoS; lifespan is not looked at, since virtual time is not the system's. Outlived
/// by none of its ends: they keep it.
class Bus : public std::enable_shared_from_this<Bus> {
 public:
  /// `participant`: its GUID, whose prefix those ends get that DDS does not know.
  explicit Bus(const Guid& participant) : participant_(participant) {}

  const Guid& participant() const { return participant_; }

  /// As of a participant. `outside`, if any, is the same end on DDS: what is written goes to both, as far as
  /// somebody hears it.
  std::unique_ptr<Writer> create_writer(const EndpointOptions& options, std::function<void()> on_match,
                                        std::unique_ptr<Writer> outside);
  /// `outside`, if any, is the same end on DDS: what comes there is taken after what waits here.
  std::unique_ptr<Reader> create_reader(const EndpointOptions& options, std::function<void()> on_sample,
                                        std::function<void()> on_match, std::unique_ptr<Reader> outside);

 private:
  struct End;
  struct WriterEnd;
  struct ReaderEnd;
  class BusWriter;
  class BusReader;

  void check_type(const EndpointOptions& options);
  /// With the mutex held, as those below.
  Guid next_guid(bool is_writer);
  void match(WriterEnd& writer, ReaderEnd& reader);
  static void give(ReaderEnd& reader, const Sample& sample);

  std::mutex mutex_;
  Guid participant_;
  std::uint32_t entities_ = 0;
  std::map<std::string, std::string> types_;  ///< of topics
  std::vector<WriterEnd*> writers_;
  std::vector<ReaderEnd*> readers_;
};

}  // namespace bw::dds
