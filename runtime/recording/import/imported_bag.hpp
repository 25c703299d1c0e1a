// An imported log as a bag: in memory, or on disk.
#pragma once

#include <filesystem>
#include <memory>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/import/import_tables.hpp"

namespace bw::imports {

/// Read like any other bag; for who needs the log and no file.
std::unique_ptr<bag::Bag> as_bag(ImportedLog log);

/// A new .mcap file, or a folder where the name does not end so: whole, or not there at all. Throws
/// std::runtime_error or std::system_error naming the path: it exists already, or cannot be written.
void write_bag(const ImportedLog& log, const std::filesystem::path& path);

}  // namespace bw::imports
