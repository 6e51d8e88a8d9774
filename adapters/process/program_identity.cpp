#include "adapters/process/program_identity.hpp"

#include "adapters/process/file_digests.hpp"
#include "adapters/process/find_program.hpp"
#include "adapters/process/shared_libraries.hpp"
#include "native/base/digest.hpp"

#include <fstream>
#include <set>
#include <sstream>

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
        for (const auto& interpreter : interpreters)
            add_program(interpreter, depth + 1);
        if (interpreters.empty()) add_libraries(program);
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
