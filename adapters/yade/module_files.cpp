#include "adapters/yade/module_files.hpp"

#include "adapters/program/error_line.hpp"

#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace crossgrain::adapters::yade {

namespace fs = std::filesystem;

namespace {

/// Its beginning: what is looked for stands there, and a program need not be a script.
std::string beginning_of(const fs::path& file) {
    constexpr std::size_t limit = std::size_t{64} << 10;
    std::ifstream in(file, std::ios::binary);
    std::string text(limit, '\0');
    in.read(text.data(), static_cast<std::streamsize>(limit));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return text;
}

/// The directory of the libraries; empty if the script does not name it.
fs::path library_directory(const fs::path& script) {
    constexpr std::string_view mark = "sys.path.insert(1,'";
    const auto line = line_starting_with(beginning_of(script), mark);
    if (!line) return {};
    const fs::path modules = line->substr(mark.size(), line->find('\'', mark.size()) - mark.size());
    std::error_code error;
    const bool packaged = modules.filename() == "py" && fs::is_directory(modules / "yade", error);
    return packaged ? modules.parent_path() : fs::path();
}

}  // namespace

std::vector<fs::path> module_files(const fs::path& script) {
    std::vector<fs::path> files;
    const fs::path directory = library_directory(script);
    if (directory.empty()) return files;
    for (const auto& entry : fs::recursive_directory_iterator(directory)) {
        const auto extension = entry.path().extension();
        const bool decides = extension == ".so" || extension == ".py";
        if (decides && entry.is_regular_file()) files.push_back(entry.path());
    }
    return files;
}

}  // namespace crossgrain::adapters::yade
