#include "app/settings.hpp"

#include "app/source_digest.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <thread>

namespace crossgrain::app {
namespace {

/// Value of the first line "name<separator>value" of a text file, without quotes.
std::string field(const char* file, const std::string& name, char separator) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(name)) continue;
        std::string value = line.substr(std::min(line.find(separator), line.size() - 1) + 1);
        std::erase(value, '"');
        return printable(value.substr(std::min(value.find_first_not_of(' '), value.size())));
    }
    return "unknown";
}

}  // namespace

std::string command_text(const std::vector<std::string>& arguments) {
    constexpr std::size_t longest = 1000;
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "%+,-./:=@_";
    std::string text = "crossgrain";
    for (const std::string& argument : arguments) {
        const std::string word = printable(argument, longest);
        if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
            text += " " + word;
            continue;
        }
        text += " '";
        for (const char c : word)
            text += c == '\'' ? std::string("'\\''") : std::string(1, c);
        text += "'";
    }
    return text;
}

std::filesystem::path share_directory() {
    namespace fs = std::filesystem;
    if (const char* given = std::getenv("CROSSGRAIN_SHARE"); given != nullptr && *given != '\0')
        return given;
    std::error_code error;
    const fs::path binary = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& candidate :
         {binary / "share/crossgrain", binary.parent_path() / "share/crossgrain"}) {
        if (fs::is_directory(candidate / "catalog", error)) return candidate;
    }
    throw CaseError({.problem = "the catalogue of cases is missing",
                     .expected = fmt::format("{}/share/crossgrain", binary.string()),
                     .hint = "build the project or set CROSSGRAIN_SHARE"});
}

std::string program_version() {
    return fmt::format("{} (source {})", CROSSGRAIN_VERSION, source_digest);
}

Machine this_machine() {
    return {.cpu = field("/proc/cpuinfo", "model name", ':'),
            .os = field("/etc/os-release", "PRETTY_NAME", '='),
            .cores = std::max(1U, std::thread::hardware_concurrency())};
}

}  // namespace crossgrain::app
