#include "tests/interop/plain/wire.hpp"

#include <algorithm>
#include <optional>

namespace plain {
namespace {

namespace rtps = bw::fast_dds::rtps;
namespace transport = bw::fast_dds::transport;

constexpr std::uint8_t kDataSubmessage = 0x15;
constexpr std::size_t kHeader = 20;  // "RTPS", version, vendor, GUID prefix

/// Numbers of a submessage in its own byte order.
class Cursor {
 public:
  Cursor(const std::uint8_t* begin, const std::uint8_t* end, bool is_little)
      : at_(begin), end_(end), is_little_(is_little) {}

  bool has(std::size_t size) const { return size <= static_cast<std::size_t>(end_ - at_); }
  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8U | at_[is_little_ ? size - 1 - i : i];
    at_ += size;
    return value;
  }
  std::int64_t sequence() {
    const std::uint64_t high = number(4);
    return static_cast<std::int64_t>(high << 32U | number(4));
  }
  Bytes bytes(std::size_t size) {
    at_ += size;
    return {at_ - size, at_};
  }
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
  bool is_little_;
};

std::optional<Data> parse_data(Cursor body, std::uint8_t flags, const std::uint8_t* prefix) {
  constexpr std::uint8_t kHasInlineQos = 2, kHasPayload = 4;
  constexpr std::uint16_t kSentinel = 1;
  if (!body.has(20)) return std::nullopt;
  Data data;
  body.number(2);  // extra flags
  body.number(2);  // octets to the inline QoS: 16 in every version so far
  body.bytes(4);   // the reader's entity id
  const Bytes entity = body.bytes(4);
  std::copy_n(prefix, 12, data.writer.begin());
  std::ranges::copy(entity, data.writer.begin() + 12);
  data.sequence = body.sequence();
  while ((flags & kHasInlineQos) != 0) {
    if (!body.has(4)) return std::nullopt;
    const auto id = static_cast<std::uint16_t>(body.number(2));
    const std::size_t length = body.number(2);
    if (id == kSentinel) break;
    if (!body.has(length)) return std::nullopt;
    data.inline_qos[id] = body.bytes(length);
  }
  if ((flags & kHasPayload) != 0) data.payload = body.bytes(body.left());
  return data;
}

class RecordedTransport final : public transport::ChainingTransport {
 public:
  RecordedTransport(const transport::ChainingTransportDescriptor& descriptor, std::shared_ptr<Wire> wire)
      : ChainingTransport(descriptor), descriptor_(descriptor), wire_(std::move(wire)) {}

  transport::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  bool send(rtps::SenderResource* below, bw::fast_dds::SendBuffer bytes, std::uint32_t size,
            rtps::LocatorsIterator* begin, rtps::LocatorsIterator* end,
            const std::chrono::steady_clock::time_point& limit) override {
    return below->send(bytes, size, begin, end, limit);
  }
  void receive(transport::TransportReceiverInterface* next, const rtps::octet* bytes, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    wire_->keep({bytes, bytes + size});
    next->OnDataReceived(bytes, size, local, remote);
  }

 private:
  struct Configuration final : transport::ChainingTransportDescriptor {
    explicit Configuration(const transport::ChainingTransportDescriptor& other)
        : transport::ChainingTransportDescriptor(other) {}
    transport::TransportInterface* create_transport() const override { return nullptr; }
  };
  Configuration descriptor_;
  std::shared_ptr<Wire> wire_;
};

class RecordedDescriptor final : public transport::ChainingTransportDescriptor {
 public:
  RecordedDescriptor(std::shared_ptr<transport::TransportDescriptorInterface> below,
                     std::shared_ptr<Wire> wire)
      : transport::ChainingTransportDescriptor(std::move(below)), wire_(std::move(wire)) {}
  transport::TransportInterface* create_transport() const override {
    return new RecordedTransport(*this, wire_);
  }

 private:
  std::shared_ptr<Wire> wire_;
};

}  // namespace

std::vector<Data> data_in(const Bytes& datagram) {
  std::vector<Data> all;
  if (datagram.size() < kHeader || std::memcmp(datagram.data(), "RTPS", 4) != 0) return all;
  const std::uint8_t* const end = datagram.data() + datagram.size();
  for (const std::uint8_t* at = datagram.data() + kHeader; end - at >= 4;) {
    const std::uint8_t id = at[0], flags = at[1];
    const bool is_little = (flags & 1) != 0;
    std::size_t length = Cursor(at + 2, end, is_little).number(2);
    at += 4;
    if (length == 0) length = static_cast<std::size_t>(end - at);  // the last one reaches to the end
    if (length > static_cast<std::size_t>(end - at)) break;
    if (id == kDataSubmessage) {
      if (auto data = parse_data(Cursor(at, at + length, is_little), flags, datagram.data() + 8))
        all.push_back(std::move(*data));
    }
    at += length;
  }
  return all;
}

void Wire::keep(Bytes datagram) {
  const std::lock_guard lock(mutex_);
  datagrams_.push_back(std::move(datagram));
}

std::vector<Data> Wire::data_of(const std::array<std::uint8_t, 16>& writer) const {
  const std::lock_guard lock(mutex_);
  std::vector<Data> all;
  for (const Bytes& datagram : datagrams_) {
    for (Data& data : data_in(datagram)) {
      if (data.writer == writer) all.push_back(std::move(data));
    }
  }
  return all;
}

std::shared_ptr<transport::TransportDescriptorInterface> recorded(
    std::shared_ptr<transport::TransportDescriptorInterface> below, std::shared_ptr<Wire> wire) {
  return std::make_shared<RecordedDescriptor>(std::move(below), std::move(wire));
}

}  // namespace plain
