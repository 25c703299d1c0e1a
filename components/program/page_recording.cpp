#include "components/program/page_recording.hpp"

#include <utility>

#include "components/program/drive_page/drive_page.hpp"

namespace bw {
namespace {

/// What a page shows is made, whether anybody else reads it or not: plan, costmap and drawings.
class Everything final : public SampleTap {
 public:
  explicit Everything(std::shared_ptr<SampleTap> tap) : tap_(std::move(tap)) {}
  void connect(const std::vector<const OutputEnd*>& outputs) override { tap_->connect(outputs); }
  void on_sample(const OutputEnd& output, Time now, std::span<const std::uint8_t> cdr) override {
    tap_->on_sample(output, now, cdr);
  }
  void run_is_over() override { tap_->run_is_over(); }

 private:
  std::shared_ptr<SampleTap> tap_;
};

}  // namespace

std::shared_ptr<SampleTap> PageRecording::open(bool waits, const bag::BagDescription& description) {
  return std::make_shared<Everything>(
      recording_.open(folder_.path() / "drive.mcap", {.writer = {}, .waits = waits}, description));
}

std::string PageRecording::finish(const Host& host, const std::string& name,
                                  const std::filesystem::path& html) {
  const std::string lost = recording_.finish(host);
  try {
    write_drive_page(folder_.path() / "drive.mcap", name, html);
  } catch (const std::exception& error) {
    return html.string() + " is not written: " + error.what();
  }
  return lost;
}

}  // namespace bw
