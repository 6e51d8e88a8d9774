#include "adapters/process/program_identity.hpp"

#include "adapters/process/file_digests.hpp"
#include "adapters/process/find_program.hpp"
#include "adapters/process/shared_libraries.hpp"
#include "native/base/digest.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;

namespace {

/// Programs that the first line of a script names: "#!/bin/sh", "#!/usr/bin/env python3". None if
/// it is no script.
std::vector<fs::path> interpreters_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    constexpr std::size_t longest_line = 256;  // that Linux reads
    std::string line(longest_line, '\0');
    in.read(line.data(), longest_line);
    line.resize(static_cast<std::size_t>(in.gcount()));
    if (!line.starts_with("#!")) return {};
    std::istringstream words(line.substr(2, line.find('\n') - 2));
    std::vector<fs::path> found;
    for (std::string word; words >> word;) {
        if (word.starts_with('-') || word.find('=') != std::string::npos) continue;
        if (const auto program = find_program(word)) found.push_back(fs::canonical(*program));
    }
    return found;
}

/// Programs and scripts that the text of a script names: by an absolute path, or behind `exec`, `.`
/// or `source`. What it puts together from variables is not seen.
std::vector<fs::path> programs_named_in(const fs::path& script) {
    std::ifstream in(script, std::ios::binary);
    constexpr std::size_t longest_script = std::size_t{1} << 16;
    std::string text(longest_script, '\0');
    in.read(text.data(), longest_script);
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.starts_with("\x7f"
                         "ELF"))
        return {};
    constexpr std::string_view between = " \t\n\r\"'`;|&()<>={}:,";
    std::vector<fs::path> found;
    bool behind_exec = false, behind_source = false;
    for (std::size_t at = text.find_first_not_of(between); at != std::string::npos;
         at = text.find_first_not_of(between, at)) {
        const std::size_t end = std::min(text.find_first_of(between, at), text.size());
        const std::string word = text.substr(at, end - at);
        const bool named = word.starts_with('/') || behind_exec, sourced = behind_source;
        behind_exec = word == "exec";
        behind_source = word == "." || word == "source";
        at = end;
        std::error_code error;
        if (word.find('\0') != std::string::npos) continue;
        if (sourced && fs::is_regular_file(word, error)) {
            found.push_back(fs::canonical(word));
        } else if (const auto program = named ? find_program(word) : std::nullopt) {
            found.push_back(fs::canonical(*program));
        }
    }
    return found;
}

class Collection {
  public:
    Collection(const ProgramFiles& files, const std::stop_token& stop)
        : files_(files), stop_(stop) {
        for (const auto& file : files.further_files)
            further_.push_back(fs::canonical(file));
        all_.insert(further_.begin(), further_.end());
    }

    /// A program and all that it loads. A script's interpreter may be a script again; not for ever.
    void add_program(const fs::path& program, int depth = 0) {
        constexpr int deepest = 4;  // as Linux has it
        if (!all_.insert(program).second || depth > deepest) return;
        const auto interpreters = interpreters_of(program);
        if (interpreters.empty()) add_libraries(program);
        for (const auto& interpreter : interpreters)
            add_program(interpreter, depth + 1);
        for (const auto& named : programs_named_in(program)) {
            try {
                add_program(named, depth + 1);
            } catch (const std::system_error&) {
                // It lacks a library; whether the script ever starts it is not known.
            }
        }
    }
    [[nodiscard]] const std::set<fs::path>& all() const noexcept { return all_; }

  private:
    void add_libraries(const fs::path& program) {
        const auto loader = loader_of(program);
        if (!loader) return;
        std::vector<fs::path> modules;
        for (const auto& file : further_) {
            if (file.extension() == ".so") modules.push_back(file);
        }
        for (const auto& library :
             shared_libraries(*loader, program, modules, files_.extra_environment, stop_))
            all_.insert(fs::canonical(library));
    }

    const ProgramFiles& files_;
    const std::stop_token& stop_;
    std::vector<fs::path> further_;
    std::set<fs::path> all_;
};

}  // namespace

ProgramIdentity identify(const ProgramFiles& files, const std::stop_token& stop) {
    const fs::path program = fs::canonical(files.program);
    Collection collection(files, stop);
    collection.add_program(program);
    FileDigests digests(FileDigests::usual_place());
    std::multiset<std::string> lines;
    for (const auto& file : collection.all())
        lines.insert(file.filename().string() + ' ' + digests.of(file, stop) + '\n');
    Sha256 digest;
    for (const auto& line : lines)
        digest.add(line);
    return {.program = program, .digest = digest.hex()};
}

}  // namespace crossgrain::adapters::process
