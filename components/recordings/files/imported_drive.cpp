#include "components/recordings/files/imported_drive.hpp"

#include "runtime/recording/import/imported_bag.hpp"

namespace bw {

BagDrive import_drive(const std::filesystem::path& columns_file,
                      const std::vector<std::filesystem::path>& tables) {
  const auto bag = imports::as_bag(imports::import_tables(imports::read_columns_file(columns_file), tables));
  return drive_of_bag(*bag, {}, columns_file.string());
}

}  // namespace bw
