// What `bandwagon doctor` says, a line for each thing that was looked at.
#pragma once

#include <ostream>
#include <string>

namespace bw::cli {

class DoctorReport {
 public:
  explicit DoctorReport(std::ostream& out) : out_(out) {}

  void ok(const std::string& text) { out_ << "ok    " << text << "\n"; }
  void warn(const std::string& text) { out_ << "warn  " << text << "\n"; }
  void fail(const std::string& text) {
    out_ << "FAIL  " << text << "\n";
    failed_ = true;
  }
  int status() const { return failed_ ? 1 : 0; }

 private:
  std::ostream& out_;
  bool failed_ = false;
};

}  // namespace bw::cli
