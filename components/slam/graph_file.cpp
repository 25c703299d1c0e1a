#include "components/slam/graph_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <zlib.h>

#include "components/slam/graph_fields.hpp"

namespace bw::slam {
namespace {

using graph::Counts;
using graph::fields;

constexpr std::string_view kMagic =
    "\x89"
    "BWG\r\n\x1a\n";
constexpr std::size_t kHeaderBytes = 20;
constexpr std::size_t kSectionBytes = 16;  // beside its content
constexpr std::uint32_t kNone = 0xffffffff;
constexpr double kMostCells = 4e8;      // of the box of a map
constexpr double kBesideSubmap = 65.0;  // [m] that beams reach

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

template <class T>
using BitsOf = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

class Writer {
 public:
  static constexpr bool kReads = false;

  template <class T>
  void number(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) out_.push_back(static_cast<char>(value >> (8U * i)));
  }
  template <class T>
  void real(const char*, const T& value, double, double) {
    number(std::bit_cast<BitsOf<T>>(value));
  }
  void real_either_sign(const char*, const double& value, double, double) {
    number(std::bit_cast<std::uint64_t>(value));
  }
  template <class T>
  void integer(const char*, const T& value, std::int64_t, std::int64_t) {
    number(static_cast<BitsOf<T>>(value));
  }
  void short_number(const std::uint16_t& value) { number(value); }
  void flag(const char*, const bool& value) { number(static_cast<std::uint8_t>(value)); }
  void index(const char*, const std::size_t& value, std::size_t) {
    number(static_cast<std::uint32_t>(value));
  }
  void exactly(const char* name, const std::size_t& value, std::size_t, const char*) {
    index(name, value, 0);
  }
  void optional_index(const char*, const std::optional<std::size_t>& value, std::size_t) {
    number(value ? static_cast<std::uint32_t>(*value) : kNone);
  }
  void covariance(const Eigen::Matrix3d& C) {
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) number(std::bit_cast<std::uint64_t>(C(row, column)));
  }
  template <class Maybe, class Each>
  void optional(const Maybe& value, Each each) {
    flag("", static_cast<bool>(value));
    if (value) each(*value);
  }
  template <class T, class Each>
  void list_of(const char*, const std::vector<T>& list, std::size_t, std::size_t, Each each) {
    for (const T& item : list) each(item);
  }
  template <class T, class Each>
  void list(const char* name, const std::vector<T>& list, std::size_t bytes, Each each) {
    number(static_cast<std::uint32_t>(list.size()));
    list_of(name, list, list.size(), bytes, each);
  }

  template <class Content>
  void section(std::string_view tag, Content content) {
    const std::size_t start = out_.size();
    out_ += tag;
    number(std::uint64_t{0});
    content();
    overwrite(start + 4, out_.size() - start - 12);
    number(checksum(std::string_view(out_).substr(start)));
  }
  void raw(std::string_view bytes) { out_ += bytes; }
  void overwrite(std::size_t at, std::uint64_t value) {
    for (std::size_t i = 0; i < 8; ++i) out_[at + i] = static_cast<char>(value >> (8U * i));
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

struct Fault {
  std::string sentence;
};

std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.9g", value);
  return buffer.data();
}

class Reader {
 public:
  static constexpr bool kReads = true;
  explicit Reader(std::string_view bytes) : bytes_(bytes), end_(bytes.size()) {}

  template <class T>
  T number(const char* name) {
    field_ = at_;
    if (end_ - at_ < sizeof(T))
      refuse(name, std::to_string(end_ - at_) + " bytes", "the section ends before it does");
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      sum |= std::uint64_t{static_cast<std::uint8_t>(bytes_[at_ + i])} << (8U * i);
    at_ += sizeof(T);
    return static_cast<T>(sum);
  }
  template <class T>
  void real(const char* name, T& value, double least, double most) {
    value = std::bit_cast<T>(number<BitsOf<T>>(name));
    const auto wide = static_cast<double>(value);
    if (!(wide >= least && wide <= most))
      refuse(name, text(wide), "must lie within " + text(least) + " and " + text(most));
  }
  void real_either_sign(const char* name, double& value, double least, double most) {
    value = std::bit_cast<double>(number<std::uint64_t>(name));
    if (!(std::abs(value) >= least && std::abs(value) <= most))
      refuse(name, text(value), "its size must lie within " + text(least) + " and " + text(most));
  }
  template <class T>
  void integer(const char* name, T& value, std::int64_t least, std::int64_t most) {
    value = static_cast<T>(number<BitsOf<T>>(name));
    if (value < least || value > most)
      refuse(name, std::to_string(value),
             "must lie within " + std::to_string(least) + " and " + std::to_string(most));
  }
  void short_number(std::uint16_t& value) { value = number<std::uint16_t>("a range"); }
  void flag(const char* name, bool& value) {
    const auto byte = number<std::uint8_t>(name);
    if (byte > 1) refuse(name, std::to_string(byte), "must be 0 or 1");
    value = byte == 1;
  }
  void index(const char* name, std::size_t& value, std::size_t end) {
    value = number<std::uint32_t>(name);
    if (value >= end) refuse(name, std::to_string(value), "must be below " + std::to_string(end));
  }
  void exactly(const char* name, std::size_t& value, std::size_t wanted, const char* what) {
    value = number<std::uint32_t>(name);
    if (value != wanted)
      refuse(name, std::to_string(value), "must be " + std::string(what) + ", " + std::to_string(wanted));
  }
  void optional_index(const char* name, std::optional<std::size_t>& value, std::size_t end) {
    const auto read = number<std::uint32_t>(name);
    if (read != kNone && read >= end)
      refuse(name, std::to_string(read), "must be below " + std::to_string(end) + ", or 4294967295 for none");
    value = read == kNone ? std::nullopt : std::optional<std::size_t>(read);
  }
  // Of what is added up and inverted: a covariance that is none lets poses become numbers that are none.
  void covariance(Eigen::Matrix3d& C) {
    const std::size_t start = at_;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) real("covariance", C(row, column), -1e12, 1e12);
    field_ = start;
    const double largest = std::max(1.0, C.cwiseAbs().maxCoeff());
    if ((C - C.transpose()).cwiseAbs().maxCoeff() > 1e-9 * largest)
      refuse("covariance", text(C(0, 1)) + " and " + text(C(1, 0)), "must be symmetric");
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(C, Eigen::EigenvaluesOnly);
    if (eigen.info() != Eigen::Success || !(eigen.eigenvalues()(0) >= -1e-9 * largest))
      refuse("covariance", "an eigenvalue of " + text(eigen.eigenvalues()(0)), "none must be negative");
  }
  template <class T, class Each>
  void optional(std::optional<T>& value, Each each) {
    bool is_there = false;
    flag("whether it is there", is_there);
    if (is_there) each(value.emplace());
  }
  template <class T, class Each>
  void optional(std::shared_ptr<const T>& value, Each each) {
    bool is_there = false;
    flag("whether it is there", is_there);
    if (!is_there) return;
    const auto made = std::make_shared<T>();
    each(*made);
    value = made;
  }
  template <class T, class Each>
  void list_of(const char* name, std::vector<T>& list, std::size_t count, std::size_t bytes, Each each) {
    if (count > (end_ - at_) / bytes)
      refuse(name, std::to_string(count),
             "has no room in the " + std::to_string(end_ - at_) + " bytes that are left");
    list.resize(count);
    for (T& item : list) each(item);
  }
  template <class T, class Each>
  void list(const char* name, std::vector<T>& list, std::size_t bytes, Each each) {
    const auto count = number<std::uint32_t>(name);
    list_of(name, list, count, bytes, each);
  }

  void header() {
    if (bytes_.substr(0, kMagic.size()) != kMagic)
      refuse("first 8 bytes", "another kind of file", "must be those of a pose graph");
    at_ = kMagic.size();
    const auto version = number<std::uint32_t>("version");
    if (version != kGraphVersion)
      refuse("version", std::to_string(version),
             "this program reads version " + std::to_string(kGraphVersion));
    const auto size = number<std::uint64_t>("size");
    if (size != bytes_.size())
      refuse("size", std::to_string(size), "the file has " + std::to_string(bytes_.size()) + " bytes");
  }
  template <class Content>
  void section(std::string_view tag, Content content) {
    section_ = tag;
    end_ = bytes_.size();
    const std::size_t start = at_;
    field_ = start;
    if (bytes_.substr(start, tag.size()) != tag) refuse("section", "another one", "must begin with its name");
    at_ += tag.size();
    const auto size = number<std::uint64_t>("length");
    if (end_ - at_ < 4 || size > end_ - at_ - 4)
      refuse("length", std::to_string(size),
             "the file ends after " + std::to_string(end_ - at_) + " bytes more");
    end_ = at_ + static_cast<std::size_t>(size);
    const std::uint32_t computed = checksum(bytes_.substr(start, end_ - start));
    const std::size_t content_at = at_;
    at_ = end_;
    end_ += 4;
    const auto stored = number<std::uint32_t>("checksum");
    if (stored != computed)
      refuse("checksum", std::to_string(stored),
             "the bytes have " + std::to_string(computed) + ": they were changed");
    at_ = content_at;
    end_ -= 4;
    content();
    field_ = at_;
    if (at_ != end_) refuse("end", std::to_string(end_ - at_) + " bytes more", "the section must end here");
    at_ += 4;
  }
  void end() {
    if (at_ != bytes_.size())
      refuse("end", std::to_string(bytes_.size() - at_) + " bytes more", "the file must end here");
  }
  [[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& rule) const {
    throw Fault{"byte " + std::to_string(field_) + (section_.empty() ? "" : " (" + section_ + ")") + ": " +
                name + ": " + value + ": " + rule};
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t end_ = 0;
  std::size_t field_ = 0;  // where the field begins that is looked at
  std::string section_;
};

// What a map of these submaps would take as a grid.
void check_size(const Reader& reader, const SlamState& slam) {
  if (slam.closing.X_MS.empty()) return;
  Vector2 low = slam.closing.X_MS.front().position();
  Vector2 high = low;
  for (const Pose2& X : slam.closing.X_MS) {
    low = low.cwiseMin(X.position());
    high = high.cwiseMax(X.position());
  }
  const Vector2 size = (high - low).array() + 2.0 * kBesideSubmap;
  if (size.prod() > kMostCells * slam.options.resolution * slam.options.resolution)
    reader.refuse("poses of the submaps", text(size.x()) + " x " + text(size.y()) + " m",
                  "a map may have " + text(kMostCells) + " cells");
}

// Of a map from which submaps have left: whatever is followed from one to another must be there.
void check_marginalised(const Reader& reader, const SlamState& slam) {
  const std::vector<Submap>& submaps = slam.closing.submaps;
  const auto has_left = [&](std::size_t k) { return submaps[k].marginalised.has_value(); };
  const auto refuse_if = [&](bool wrong, const char* name, std::size_t number, const char* rule) {
    if (wrong) reader.refuse(name, std::to_string(number), rule);
  };
  for (const Submap& submap : submaps)
    if (const auto& anchor = submap.marginalised)
      refuse_if(has_left(anchor->submap), "anchor", anchor->submap, "must be a submap that is there");
  for (std::size_t n = 0; n < slam.nodes.size(); ++n) {
    const std::size_t k = slam.nodes[n].placement.submap;
    refuse_if(!slam.nodes[n].ranges && (k >= submaps.size() || !has_left(k)), "node", n,
              "must have ranges, as its submap is there");
  }
  // By edges of the drive, to the earliest submap of those that hang together.
  std::vector<std::size_t> earliest(submaps.size());
  std::iota(earliest.begin(), earliest.end(), std::size_t{0});
  const auto find = [&](std::size_t k) {
    while (earliest[k] != k) k = earliest[k] = earliest[earliest[k]];
    return k;
  };
  const auto check = [&](const Edge& edge) {
    for (const std::size_t end : {edge.from, edge.to})
      refuse_if(has_left(end), "end of an edge", end, "must be a submap that is there");
  };
  for (const Edge& edge : slam.closing.edges) {
    check(edge);
    if (edge.loop) continue;
    const auto [low, high] = std::minmax({find(edge.from), find(edge.to)});
    earliest[high] = low;
  }
  for (const Loop& loop : slam.closing.pending) {
    check(loop.edge);
    refuse_if(!loop.edge.loop, "loop", loop.edge.to, "must be marked as one");
  }
  std::optional<std::size_t> first;
  for (std::size_t k = 0; k < submaps.size(); ++k) {
    if (has_left(k)) continue;
    if (!first) first = find(k);
    refuse_if(find(k) != *first, "submap", k, "edges of the drive must lead to it");
  }
}

// The whole file but its first 20 bytes.
template <class Io>
void sections(Io& io, graph::Field<Io, SavedGraph> saved) {
  auto& slam = saved.slam;
  Counts counts{slam.closing.submaps.size(), slam.nodes.size(), 0};
  io.section("HEAD", [&] {
    fields(io, slam.options);
    fields(io, saved.X_MW, graph::kFarthest);
    io.integer("scans", slam.counts.scans, 0, graph::kMaxInteger);
    io.integer("unmatched", slam.counts.unmatched, 0, graph::kMaxInteger);
    if constexpr (Io::kReads) {
      io.index("submaps", counts.submaps, kNone);
      io.index("nodes", counts.nodes, kNone);
    } else {
      io.index("submaps", counts.submaps, 0);
      io.index("nodes", counts.nodes, 0);
    }
  });
  io.section("SUBM", [&] {
    std::size_t k = 0;
    if constexpr (Io::kReads) {
      io.list_of("submaps", slam.closing.submaps, counts.submaps, graph::kSubmapBytes, [&](Submap& submap) {
        fields(io, submap, slam.closing.X_MS.emplace_back(), k++, counts);
        submap.all_round = all_round(submap.surfaces);
        submap.centre = centre(submap.surfaces);
      });
      check_size(io, slam);
    } else {
      for (; k < counts.submaps; ++k) fields(io, slam.closing.submaps[k], slam.closing.X_MS[k], k, counts);
    }
  });
  io.section("TRCK", [&] { fields(io, slam.tracking, slam.options.resolution, counts); });
  counts.under_way = (slam.tracking.older ? 1U : 0U) + (slam.tracking.younger ? 1U : 0U);
  io.section("NODE", [&] {
    io.list_of("nodes", slam.nodes, counts.nodes, graph::kNodeBytes,
               [&](auto& node) { fields(io, node, counts); });
  });
  io.section("EDGE", [&] {
    io.list("edges", slam.closing.edges, graph::kEdgeBytes, [&](auto& edge) { fields(io, edge, counts); });
  });
  io.section("LOOP", [&] {
    io.list("loops that wait", slam.closing.pending, graph::kLoopBytes,
            [&](auto& loop) { fields(io, loop, counts); });
    fields(io, slam.closing.newest_in_first, 1e9);
    io.index("turn", slam.closing.turn, std::size_t{kNone} + 1);
    fields(io, slam.closing.counts);
    if constexpr (Io::kReads) check_marginalised(io, slam);
  });
}

}  // namespace

std::string graph_bytes(const SavedGraph& graph) {
  Writer writer;
  writer.raw(kMagic);
  writer.number(kGraphVersion);
  writer.number(std::uint64_t{0});
  sections(writer, graph);
  std::string bytes = writer.take();
  for (std::size_t i = 0; i < 8; ++i)
    bytes[12 + i] = static_cast<char>(std::uint64_t{bytes.size()} >> (8U * i));
  return bytes;
}

GraphReading read_graph(std::string_view bytes) {
  GraphReading reading;
  try {
    Reader reader(bytes);
    reader.header();
    sections(reader, reading.graph.emplace());
    reader.end();
  } catch (const Fault& fault) {
    reading.graph.reset();
    reading.fault = fault.sentence;
  }
  return reading;
}

}  // namespace bw::slam
