// A piece of serial cable between an emulated device and a host: it passes bytes both ways, remembers what
// the host sent and when, and can be pulled out of the host and put back.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

namespace bw::test {

struct Chunk {
  std::chrono::steady_clock::time_point time;
  std::uint64_t plugging = 0;  ///< so often the cable had been put in
  std::vector<std::uint8_t> bytes;
};

class CableBetween {
 public:
  /// `device`: the line of the emulator, which may come later. `host`: the name under which the host finds
  /// this cable.
  CableBetween(std::filesystem::path device, std::filesystem::path host);
  ~CableBetween();
  CableBetween(const CableBetween&) = delete;
  CableBetween& operator=(const CableBetween&) = delete;

  /// The moment at which the line was gone.
  std::chrono::steady_clock::time_point pull();
  void put_back();
  std::uint64_t pluggings() const { return pluggings_; }
  /// What the host has sent since the last call.
  std::vector<Chunk> take_sent();

 private:
  void pass_on();
  void pass_from_host(int master);
  void pass_from_device(int master);
  void open_device();
  void wait_for(int descriptor, std::uint32_t what);

  std::filesystem::path device_path_, host_path_;
  int events_;        ///< what the thread waits for
  int end_;           ///< ends its waiting
  int device_ = -1;   ///< of the thread
  std::mutex mutex_;  ///< of what follows
  int master_ = -1;
  std::vector<Chunk> sent_;
  std::atomic<std::uint64_t> pluggings_ = 0;
  std::atomic<bool> is_over_ = false;
  std::thread thread_;
};

}  // namespace bw::test
