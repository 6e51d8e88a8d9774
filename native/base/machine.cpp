#include "native/base/machine.hpp"

#include "native/base/printable.hpp"

#include <algorithm>
#include <fstream>
#include <thread>

namespace crossgrain {
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

Machine this_machine() {
    return {.cpu = field("/proc/cpuinfo", "model name", ':'),
            .os = field("/etc/os-release", "PRETTY_NAME", '='),
            .cores = std::max(1U, std::thread::hardware_concurrency())};
}

}  // namespace crossgrain
