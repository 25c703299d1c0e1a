// What was thrown: in words for people, and kept by a thread beside the lanes for whoever has to hear of it.
#pragma once

#include <exception>
#include <mutex>
#include <string>
#include <utility>

namespace bw {

/// Of the exception that is handled now.
inline std::string thrown_text() {
  try {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "something that is no std::exception";
  }
}

/// What a thread of one's own threw. Let out of the thread it would end the process; thrown again on the lane
/// of its owner it ends the run as whatever a callback throws does: told, with everybody brought to rest.
class KeptException {
 public:
  /// False: `work` threw. Of several the first is kept. On any thread.
  template <class Work>
  bool run(const Work& work) noexcept {
    try {
      work();
      return true;
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!kept_) kept_ = std::current_exception();
      return false;
    }
  }
  /// Throws what was kept, once.
  void rethrow() {
    std::exception_ptr kept;
    {
      const std::lock_guard lock(mutex_);
      kept = std::exchange(kept_, nullptr);
    }
    if (kept) std::rethrow_exception(kept);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr kept_;  ///< guarded by mutex_
};

}  // namespace bw
