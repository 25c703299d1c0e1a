#include "components/lab/bench/bench_bag.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "components/lab/bench/bag_material.hpp"
#include "components/lab/bench/bag_reading.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "runtime/recording/bag/bag_writer.hpp"

namespace bw {
namespace {

using nlohmann::ordered_json;

constexpr double kGb = 1e9;
constexpr double kSpare = 0.5e9;  // left free on the disk [bytes]

bag::Compression compression_of(const std::string& name) {
  return bag::compression_of(name == "none" ? "" : name).value();
}

void require_space(const std::filesystem::path& folder, double bytes) {
  const auto free = static_cast<double>(std::filesystem::space(folder).available);
  if (free < bytes + kSpare) {
    throw std::runtime_error(fmt::format("{} has {:.1f} GB free; {:.1f} GB are needed", folder.string(),
                                         free / kGb, (bytes + kSpare) / kGb));
  }
}

/// Removes the bag with itself, also when something is thrown.
class Scratch {
 public:
  Scratch(const std::filesystem::path& folder, const std::string& name, bool keep)
      : path(folder / (name + "_" + std::to_string(getpid()) + ".mcap")), keep_(keep) {}
  ~Scratch() {
    std::error_code ignored;
    if (!keep_) std::filesystem::remove(path, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path path;

 private:
  bool keep_;
};

void wait_for_disk(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  static_cast<void>(fdatasync(descriptor));
  close(descriptor);
}

/// The material over and over, until `bytes` of messages are written.
ordered_json write_bag(const std::filesystem::path& path, const BagMaterial& material, double bytes,
                       bag::Compression compression) {
  const double cpu_before = process_cpu_ms();
  const auto before = std::chrono::steady_clock::now();
  bag::BagWriter writer(path, {.compression = compression});
  for (const bag::BagTopic& topic : material.topics) writer.add_topic(topic);
  double written = 0.0;
  Time start{1'000'000'000'000};
  for (; written < bytes; start = start + material.length) {
    for (const BagMaterial::Message& m : material.messages) {
      writer.write(m.topic, start + m.at, start + m.at, m.cdr);
      written += static_cast<double>(m.cdr.size());
      if (written >= bytes) break;
    }
  }
  writer.close();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  const double cpu_s = 1e-3 * (process_cpu_ms() - cpu_before);
  wait_for_disk(path);
  const double on_disk_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  return {{"messages", writer.message_count()},
          {"message_bytes", written},
          {"file_bytes", std::filesystem::file_size(path)},
          {"seconds", seconds},
          {"cpu_seconds", cpu_s},
          {"mb_per_s", 1e-6 * written / seconds},
          {"mb_per_cpu_s", 1e-6 * written / cpu_s},
          {"mb_per_s_on_disk", 1e-6 * written / on_disk_s}};
}

ordered_json write_rates(const BenchBagArguments& arguments, const BagMaterial& material) {
  ordered_json rates;
  for (const char* name : {"none", "lz4", "zstd"}) {
    const Scratch scratch(arguments.folder, std::string("bench_") + name, false);
    require_space(arguments.folder, arguments.write_gb * kGb);
    ordered_json rate = write_bag(scratch.path, material, arguments.write_gb * kGb, compression_of(name));
    const auto figure = [&](const char* key) { return rate[key].get<double>(); };
    std::printf(
        "write, %-4s %6.0f MB/s of messages (%.0f until it is on the disk, %.0f of CPU time), file %.2f of them\n",
        name, figure("mb_per_s"), figure("mb_per_s_on_disk"), figure("mb_per_cpu_s"),
        figure("file_bytes") / figure("message_bytes"));
    std::fflush(stdout);
    rates[name] = std::move(rate);
  }
  return rates;
}

/// In a process of its own: what this one wrote with is not counted as memory of a reader.
void read_apart(const std::filesystem::path& bag, int seeks, const std::filesystem::path& json) {
  const pid_t child = fork();
  if (child == 0) {
    const std::string count = std::to_string(seeks);
    execl("/proc/self/exe", "bandwagon", "bench", "bag", "--read", bag.c_str(), "--seeks", count.c_str(),
          "--json", json.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0)
    throw std::runtime_error("the reading process failed on " + bag.string());
}

}  // namespace

int bench_bag(const BenchBagArguments& arguments) {
  if (!arguments.read.empty()) {
    write_json(arguments.json, read_figures(arguments.read, arguments.seeks, arguments.seed));
    return 0;
  }
  const BagMaterial material = make_bag_material(arguments.seed);
  ordered_json result = {{"write", write_rates(arguments, material)}};
  require_space(arguments.folder, arguments.size_gb * kGb);
  const Scratch large(arguments.folder, "bench_large", arguments.keep);
  const Scratch figures(arguments.folder, "bench_reading", false);
  const ordered_json made =
      write_bag(large.path, material, arguments.size_gb * kGb, compression_of(arguments.compression));
  std::printf("%s: %.2f GB of messages, %.2f GB\n", large.path.c_str(),
              made["message_bytes"].get<double>() / kGb, made["file_bytes"].get<double>() / kGb);
  result["large"] = made;
  std::fflush(stdout);
  read_apart(large.path, arguments.seeks, figures.path);
  result["read"] = read_json(figures.path);
  write_json(arguments.json, result);
  return 0;
}

}  // namespace bw
