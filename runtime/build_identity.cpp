#include "runtime/build_identity.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include <elf.h>
#include <link.h>
#include <unistd.h>

namespace bw {
namespace {

std::string hexadecimal(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < size; ++i) {
    text += kDigits[bytes[i] >> 4U];
    text += kDigits[bytes[i] & 15U];
  }
  return text;
}

/// The build id among the notes of a loaded module; empty if it has none.
std::string id_in(const std::uint8_t* notes, std::size_t size) {
  const auto padded = [](std::size_t n) { return (n + 3) / 4 * 4; };
  std::size_t at = 0;
  while (at + sizeof(ElfW(Nhdr)) <= size) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes + at, sizeof(note));
    const std::size_t name = at + sizeof(note);
    const std::size_t content = name + padded(note.n_namesz);
    if (content + note.n_descsz > size) break;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(notes + name, "GNU", 4) == 0) {
      return hexadecimal(notes + content, note.n_descsz);
    }
    at = content + padded(note.n_descsz);
  }
  return {};
}

int add_module(dl_phdr_info* module, std::size_t, void* out) {
  // The program itself has no name here.
  const std::string_view name = module->dlpi_name;
  if (!name.empty() && name.find("libbandwagon") == std::string_view::npos) return 0;
  for (int i = 0; i < module->dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = module->dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    const auto* notes = reinterpret_cast<const std::uint8_t*>(module->dlpi_addr + header.p_vaddr);
    const std::string id = id_in(notes, header.p_memsz);
    auto& all = *static_cast<std::string*>(out);
    if (!id.empty()) all += (all.empty() ? "" : "+") + id;
  }
  return 0;
}

}  // namespace

std::string build_id() {
  std::string all;
  dl_iterate_phdr(add_module, &all);
  return all;
}

std::string cpu_type() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    constexpr std::string_view kKey = "model name";
    const std::size_t colon = line.find(": ");
    if (line.starts_with(kKey) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string program_version() { return BANDWAGON_VERSION; }

std::string source_revision() { return BANDWAGON_REVISION; }

std::string compiler() { return BANDWAGON_COMPILER; }

}  // namespace bw
