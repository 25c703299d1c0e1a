#include "runtime/recording/record/writer_intake.hpp"

namespace bw::record {

bool WriterIntake::accept(std::uint64_t sequence, bool by_own) {
  if (!by_own) {
    if (last_own_ > 0 || sequence <= last_other_) return false;
    if (first_other_ == 0) first_other_ = sequence;
    last_other_ = sequence;
    return true;
  }
  if (sequence <= last_own_) return false;
  if (last_own_ > 0) lost_ += sequence - last_own_ - 1;
  last_own_ = sequence;
  const bool came_before = first_other_ > 0 && sequence >= first_other_ && sequence <= last_other_;
  return !came_before;
}

}  // namespace bw::record
