#include "runtime/ros/discovery_info.hpp"

#include <algorithm>

#include "runtime/wire/cdr_reader.hpp"

namespace bw {
namespace {

std::size_t gid_size(GidFormat format) { return format == GidFormat::humble ? 24 : 16; }

class Encoder {
 public:
  explicit Encoder(GidFormat format) : gid_size_(gid_size(format)) {}

  void gid(const dds::Guid& guid) {
    bytes_.insert(bytes_.end(), guid.begin(), guid.end());
    bytes_.resize(bytes_.size() + gid_size_ - guid.size());
  }
  void length(std::size_t n) {
    while (bytes_.size() % 4 != 0) bytes_.push_back(0);
    for (int shift = 0; shift < 32; shift += 8) bytes_.push_back(static_cast<std::uint8_t>(n >> shift));
  }
  void text(const std::string& s) {
    length(s.size() + 1);
    bytes_.insert(bytes_.end(), s.begin(), s.end());
    bytes_.push_back(0);
  }
  void gids(const std::vector<dds::Guid>& all) {
    length(all.size());
    for (const dds::Guid& guid : all) gid(guid);
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::size_t gid_size_;
  std::vector<std::uint8_t> bytes_ = {0, 1, 0, 0};  // the header is 4 bytes, so alignment is that of the body
};

class Decoder {
 public:
  Decoder(std::span<const std::uint8_t> cdr, GidFormat format)
      : reader_(cdr), size_(cdr.size()), gid_size_(gid_size(format)) {}

  std::optional<ParticipantEntities> run() {
    ParticipantEntities result;
    std::uint32_t nodes = 0;
    if (!reader_.open() || !gid(result.participant) || !reader_.read(nodes)) return std::nullopt;
    for (std::uint32_t i = 0; i < nodes; ++i) {
      NodeEntities node;
      if (!text(node.node_namespace) || !text(node.name) || !gids(node.readers) || !gids(node.writers))
        return std::nullopt;
      if (!node.node_namespace.starts_with('/') || node.name.empty()) return std::nullopt;
      result.nodes.push_back(std::move(node));
    }
    const std::size_t left = size_ - 4 - reader_.offset();
    if (left >= 4) return std::nullopt;  // the other format, or not this message
    return result;
  }

 private:
  bool gid(dds::Guid& guid) {
    const std::uint8_t* first = nullptr;
    if (!reader_.skip(gid_size_, 1, &first)) return false;
    std::copy_n(first, guid.size(), guid.begin());
    return true;
  }
  bool text(std::string& s) {
    std::string_view view;
    if (!reader_.read(view)) return false;
    s = view;
    return true;
  }
  bool gids(std::vector<dds::Guid>& all) {
    std::uint32_t count = 0;
    if (!reader_.read(count)) return false;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!gid(all.emplace_back())) return false;
    }
    return true;
  }

  CdrReader reader_;
  std::size_t size_;
  std::size_t gid_size_;
};

}  // namespace

std::vector<std::uint8_t> encode(const ParticipantEntities& entities, GidFormat format) {
  Encoder out(format);
  out.gid(entities.participant);
  out.length(entities.nodes.size());
  for (const NodeEntities& node : entities.nodes) {
    out.text(node.node_namespace);
    out.text(node.name);
    out.gids(node.readers);
    out.gids(node.writers);
  }
  return out.take();
}

std::optional<ParticipantEntities> decode_participant_entities(std::span<const std::uint8_t> cdr) {
  if (auto result = Decoder(cdr, GidFormat::iron_and_later).run()) return result;
  return Decoder(cdr, GidFormat::humble).run();
}

}  // namespace bw
