// Which program on which kind of processor: what equal bytes depend on besides graph and seed.
#pragma once

#include <string>

namespace bw {

/// The linker's build ids of this program and of the project's own libraries that it has loaded, in
/// hexadecimal, joined by `+`. It changes with any change of code or compiler.
[[nodiscard]] std::string build_id();

/// The processor's name, as its vendor gives it; "unknown" where the system does not tell.
[[nodiscard]] std::string cpu_type();

[[nodiscard]] std::string host_name();

[[nodiscard]] std::string program_version();
/// The git revision of the sources when the build was configured; empty where there was none.
[[nodiscard]] std::string source_revision();
/// Name and version of what compiled this: GCC 12.2.0.
[[nodiscard]] std::string compiler();

}  // namespace bw
