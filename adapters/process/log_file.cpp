#include "adapters/process/log_file.hpp"

#include <algorithm>
#include <fstream>

namespace crossgrain::adapters::process {

std::string read_text(const std::filesystem::path& file, std::size_t limit) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    if (!in) return {};
    const auto size = static_cast<std::size_t>(std::max<std::streamoff>(in.tellg(), 0));
    const std::size_t wanted = std::min(size, limit);
    std::string text(wanted, '\0');
    in.seekg(static_cast<std::streamoff>(size - wanted));
    in.read(text.data(), static_cast<std::streamsize>(wanted));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return text;
}

std::string tail(const std::filesystem::path& file, std::size_t lines) {
    constexpr std::size_t longest_line = 1024;
    std::string text = read_text(file, lines * longest_line);
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    std::size_t start = text.size();
    for (std::size_t line = 0; line < lines && start != std::string::npos && start > 0; ++line) {
        start = text.rfind('\n', start - 1);
    }
    if (lines == 0) return {};
    return start == std::string::npos || start == 0 ? text : text.substr(start + 1);
}

}  // namespace crossgrain::adapters::process
