#include "runtime/dds/bus.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace bw::dds {
namespace {

Time system_time() {
  return {std::chrono::duration_cast<std::chrono::nanoseconds>(
              std::chrono::system_clock::now().time_since_epoch())
              .count()};
}

}  // namespace

struct Bus::End {
  std::string topic;
  std::string type;
  Qos qos;
  Guid guid{};
  std::function<void()> on_match;

  bool is_full(const std::deque<Sample>& samples) const {
    return samples.size() >= static_cast<std::size_t>(qos.depth);
  }
};

struct Bus::ReaderEnd : End {
  std::function<void()> on_sample;
  std::deque<Sample> waiting;
  std::vector<std::vector<std::uint8_t>> spare;  ///< buffers of samples that were taken
  int writers = 0;
};

struct Bus::WriterEnd : End {
  std::vector<ReaderEnd*> readers;
  std::deque<Sample> kept;  ///< transient local: for readers who come later
  std::uint64_t sequence = 0;
};

class Bus::BusWriter final : public Writer {
 public:
  BusWriter(std::shared_ptr<Bus> bus, End end, std::unique_ptr<Writer> outside)
      : bus_(std::move(bus)), outside_(std::move(outside)), own_{std::move(end), {}, {}, 0} {
    const std::lock_guard lock(bus_->mutex_);
    own_.guid = outside_ ? outside_->guid() : bus_->next_guid(true);
    bus_->writers_.push_back(&own_);
    for (ReaderEnd* reader : bus_->readers_) bus_->match(own_, *reader);
  }
  ~BusWriter() override {
    const std::lock_guard lock(bus_->mutex_);
    std::erase(bus_->writers_, &own_);
    for (ReaderEnd* reader : own_.readers) {
      --reader->writers;
      if (reader->on_match) reader->on_match();
    }
  }
  BusWriter(const BusWriter&) = delete;
  BusWriter& operator=(const BusWriter&) = delete;

  bool write(std::span<const std::uint8_t> cdr) override {
    give(cdr, {});
    return !is_heard_outside() || outside_->write(cdr);
  }
  std::optional<SampleIdentity> write_related(std::span<const std::uint8_t> cdr,
                                              const SampleIdentity& related) override {
    const SampleIdentity identity = give(cdr, related);
    if (is_heard_outside() && !outside_->write_related(cdr, related)) return std::nullopt;
    return identity;
  }
  Guid guid() const override { return own_.guid; }
  int matched_readers() const override {
    const std::lock_guard lock(bus_->mutex_);
    return static_cast<int>(own_.readers.size()) + (outside_ ? outside_->matched_readers() : 0);
  }
  bool is_matched(const Guid& reader) const override {
    {
      const std::lock_guard lock(bus_->mutex_);
      if (std::ranges::any_of(own_.readers, [&](const ReaderEnd* one) { return one->guid == reader; }))
        return true;
    }
    return outside_ && outside_->is_matched(reader);
  }
  bool wait_until_received(Duration limit) override {
    return !outside_ || outside_->wait_until_received(limit);
  }

 private:
  bool is_heard_outside() const {
    return outside_ &&
           (own_.qos.durability == Durability::transient_local || outside_->matched_readers() > 0);
  }
  SampleIdentity give(std::span<const std::uint8_t> cdr, const SampleIdentity& related) {
    const Time now = system_time();
    const std::lock_guard lock(bus_->mutex_);
    sample_.cdr.assign(cdr.begin(), cdr.end());
    sample_.writer = own_.guid;
    sample_.sequence = ++own_.sequence;
    sample_.related = related;
    sample_.received = sample_.sent = now;
    if (own_.qos.durability == Durability::transient_local) {
      if (own_.is_full(own_.kept)) own_.kept.pop_front();
      own_.kept.push_back(sample_);
    }
    for (ReaderEnd* reader : own_.readers) Bus::give(*reader, sample_);
    return {own_.guid, static_cast<std::int64_t>(sample_.sequence)};
  }

  std::shared_ptr<Bus> bus_;
  std::unique_ptr<Writer> outside_;
  WriterEnd own_;
  Sample sample_;
};

class Bus::BusReader final : public Reader {
 public:
  BusReader(std::shared_ptr<Bus> bus, End end, std::function<void()> on_sample,
            std::unique_ptr<Reader> outside)
      : bus_(std::move(bus)),
        outside_(std::move(outside)),
        own_{std::move(end), std::move(on_sample), {}, {}, 0} {
    const std::lock_guard lock(bus_->mutex_);
    own_.guid = outside_ ? outside_->guid() : bus_->next_guid(false);
    bus_->readers_.push_back(&own_);
    for (WriterEnd* writer : bus_->writers_) bus_->match(*writer, own_);
  }
  ~BusReader() override {
    const std::lock_guard lock(bus_->mutex_);
    std::erase(bus_->readers_, &own_);
    for (WriterEnd* writer : bus_->writers_) {
      if (std::erase(writer->readers, &own_) > 0 && writer->on_match) writer->on_match();
    }
  }
  BusReader(const BusReader&) = delete;
  BusReader& operator=(const BusReader&) = delete;

  bool take(Sample& sample) override {
    {
      const std::lock_guard lock(bus_->mutex_);
      if (!own_.waiting.empty()) {
        std::swap(sample, own_.waiting.front());
        own_.spare.push_back(std::move(own_.waiting.front().cdr));
        own_.waiting.pop_front();
        return true;
      }
    }
    return outside_ && outside_->take(sample);
  }
  Guid guid() const override { return own_.guid; }
  int matched_writers() const override {
    const std::lock_guard lock(bus_->mutex_);
    return own_.writers + (outside_ ? outside_->matched_writers() : 0);
  }

 private:
  std::shared_ptr<Bus> bus_;
  std::unique_ptr<Reader> outside_;
  ReaderEnd own_;
};

std::unique_ptr<Writer> Bus::create_writer(const EndpointOptions& options, std::function<void()> on_match,
                                           std::unique_ptr<Writer> outside) {
  check_type(options);
  End end{options.topic, options.type, options.qos, {}, std::move(on_match)};
  return std::make_unique<BusWriter>(shared_from_this(), std::move(end), std::move(outside));
}

std::unique_ptr<Reader> Bus::create_reader(const EndpointOptions& options, std::function<void()> on_sample,
                                           std::function<void()> on_match, std::unique_ptr<Reader> outside) {
  check_type(options);
  End end{options.topic, options.type, options.qos, {}, std::move(on_match)};
  return std::make_unique<BusReader>(shared_from_this(), std::move(end), std::move(on_sample),
                                     std::move(outside));
}

void Bus::check_type(const EndpointOptions& options) {
  const std::lock_guard lock(mutex_);
  const std::string& known = types_.emplace(options.topic, options.type).first->second;
  if (known != options.type) {
    throw std::runtime_error("topic " + options.topic + " carries " + known + ", not " + options.type);
  }
}

/// Entity ids as of DDS (RTPS 9.3.1.2) from where it does not come in a process's life.
Guid Bus::next_guid(bool is_writer) {
  constexpr std::uint32_t kFirst = 0x800000;
  constexpr std::uint8_t kWriterNoKey = 0x03, kReaderNoKey = 0x04;
  const std::uint32_t number = kFirst + entities_++;
  Guid guid = participant_;
  guid[12] = static_cast<std::uint8_t>(number >> 16U);
  guid[13] = static_cast<std::uint8_t>(number >> 8U);
  guid[14] = static_cast<std::uint8_t>(number);
  guid[15] = is_writer ? kWriterNoKey : kReaderNoKey;
  return guid;
}

void Bus::match(WriterEnd& writer, ReaderEnd& reader) {
  if (writer.topic != reader.topic || writer.type != reader.type || !is_compatible(writer.qos, reader.qos))
    return;
  writer.readers.push_back(&reader);
  ++reader.writers;
  if (writer.on_match) writer.on_match();
  if (reader.on_match) reader.on_match();
  if (reader.qos.durability != Durability::transient_local) return;
  for (const Sample& sample : writer.kept) give(reader, sample);
}

void Bus::give(ReaderEnd& reader, const Sample& sample) {
  if (reader.is_full(reader.waiting)) {
    reader.spare.push_back(std::move(reader.waiting.front().cdr));
    reader.waiting.pop_front();
  }
  Sample& given = reader.waiting.emplace_back();
  if (!reader.spare.empty()) {
    given.cdr = std::move(reader.spare.back());
    reader.spare.pop_back();
  }
  given = sample;
  reader.on_sample();
}

}  // namespace bw::dds
