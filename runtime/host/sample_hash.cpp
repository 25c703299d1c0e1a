#include "runtime/host/sample_hash.hpp"

#include <array>
#include <stdexcept>

#include <openssl/evp.h>

namespace bw {

struct SampleHash::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  State() {
    if (context == nullptr || EVP_DigestInit_ex(context, EVP_sha256(), nullptr) != 1) {
      throw std::runtime_error("OpenSSL offers no SHA-256");
    }
  }
  ~State() { EVP_MD_CTX_free(context); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

SampleHash::SampleHash() : state_(std::make_unique<State>()) {}
SampleHash::~SampleHash() = default;

void SampleHash::add(std::string_view topic, Time time, std::span<const std::uint8_t> bytes) {
  // Lengths go in too, so that no two sequences of samples read as the same bytes.
  const std::array<std::int64_t, 3> head = {static_cast<std::int64_t>(topic.size()), time.nanoseconds,
                                            static_cast<std::int64_t>(bytes.size())};
  EVP_DigestUpdate(state_->context, head.data(), sizeof(head));
  EVP_DigestUpdate(state_->context, topic.data(), topic.size());
  EVP_DigestUpdate(state_->context, bytes.data(), bytes.size());
}

std::string SampleHash::hex() const {
  EVP_MD_CTX* copy = EVP_MD_CTX_new();
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  EVP_MD_CTX_copy_ex(copy, state_->context);
  EVP_DigestFinal_ex(copy, digest.data(), &length);
  EVP_MD_CTX_free(copy);
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    text += kDigits[digest[i] >> 4U];
    text += kDigits[digest[i] & 15U];
  }
  return text;
}

}  // namespace bw
