#include "adapters/run/whole_file.hpp"

#include "native/base/errors.hpp"

#include <fstream>

namespace crossgrain::run {

void write_whole_file(const std::filesystem::path& file, std::string_view text) {
    const std::filesystem::path unfinished = file.string() + ".part";
    std::ofstream out(unfinished, std::ios::binary);
    out << text;
    out.close();
    if (!out) {
        throw CaseError({.file = unfinished.string(),
                         .problem = "cannot be written",
                         .expected = "a directory with room in it"});
    }
    std::filesystem::rename(unfinished, file);
}

}  // namespace crossgrain::run
