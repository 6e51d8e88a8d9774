#include "adapters/process/shared_libraries.hpp"

#include "adapters/process/question.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include <elf.h>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;

namespace {

template <class T>
bool read_at(std::ifstream& in, std::uint64_t offset, T& value) {
    in.clear();
    in.seekg(static_cast<std::streamoff>(offset));
    return static_cast<bool>(in.read(reinterpret_cast<char*>(&value), sizeof value));
}

/// The path in the segment PT_INTERP.
template <class Header, class Segment>
std::optional<fs::path> interpreter_in(std::ifstream& in) {
    Header header{};
    if (!read_at(in, 0, header)) return std::nullopt;
    for (unsigned i = 0; i < header.e_phnum; ++i) {
        Segment segment{};
        if (!read_at(in, header.e_phoff + std::uint64_t{i} * header.e_phentsize, segment)) break;
        if (segment.p_type != PT_INTERP) continue;
        constexpr std::uint64_t longest_path = 4096;
        std::string path(std::min<std::uint64_t>(segment.p_filesz, longest_path), '\0');
        in.seekg(static_cast<std::streamoff>(segment.p_offset));
        if (!in.read(path.data(), static_cast<std::streamsize>(path.size()))) break;
        return fs::path(path.c_str());  // up to its NUL
    }
    return std::nullopt;
}

/// "/lib/libc.so.6" from "libc.so.6 => /lib/libc.so.6 (0x7f...)" or "/lib/libc.so.6 (0x7f...)".
std::string path_in(const std::string& line) {
    const std::size_t arrow = line.find(" => ");
    const std::size_t start = line.find('/', arrow == std::string::npos ? 0 : arrow);
    const std::size_t end = line.rfind(" (0x");
    if (start == std::string::npos || end == std::string::npos || end < start) return {};
    return line.substr(start, end - start);
}

[[noreturn]] void fail(const std::string& words, const fs::path& executable) {
    throw std::system_error(ELIBACC, std::generic_category(),
                            fmt::format("{}: {}", executable.string(), words));
}

/// A list that the loader reads; what would end a name in it is left out.
std::string preload_list(const std::vector<fs::path>& modules) {
    std::string list;
    for (const auto& module : modules) {
        if (module.string().find_first_of(": ") == std::string::npos)
            list += (list.empty() ? "" : ":") + module.string();
    }
    return list;
}

}  // namespace

std::optional<fs::path> loader_of(const fs::path& executable) {
    std::ifstream in(executable, std::ios::binary);
    if (!in) throw std::system_error(errno, std::generic_category(), executable.string());
    unsigned char identification[EI_NIDENT]{};
    if (!read_at(in, 0, identification) || std::memcmp(identification, ELFMAG, SELFMAG) != 0)
        return std::nullopt;
    return identification[EI_CLASS] == ELFCLASS64 ? interpreter_in<Elf64_Ehdr, Elf64_Phdr>(in)
                                                  : interpreter_in<Elf32_Ehdr, Elf32_Phdr>(in);
}

std::vector<fs::path> shared_libraries(const fs::path& loader, const fs::path& executable,
                                       const std::vector<fs::path>& modules,
                                       const std::vector<std::string>& extra_environment,
                                       const std::stop_token& stop) {
    Question question{.argv = {loader.string(), "--list", executable.string()},
                      .extra_environment = extra_environment,
                      .time_limit = 30,
                      .stop = stop};
    if (const std::string list = preload_list(modules); !list.empty()) {
        question.argv.insert(question.argv.begin() + 1, {"--preload", list});
    }
    const Answer answer = ask(question);
    if (answer.ending == Ending::stopped) throw Interrupted();
    if (answer.ending != Ending::exited || answer.status != 0) {
        fail(answer.err.empty() ? answer.ended : answer.err, executable);
    }
    std::vector<fs::path> libraries;
    std::istringstream lines(answer.out);
    for (std::string line; std::getline(lines, line);) {
        if (line.find("=> not found") != std::string::npos) {
            fail(line.substr(line.find_first_not_of(" \t")), executable);
        }
        if (auto path = path_in(line); !path.empty()) libraries.emplace_back(std::move(path));
    }
    return libraries;
}

}  // namespace crossgrain::adapters::process
