#include "cases/toml/text_file.hpp"

#include "native/base/errors.hpp"
#include "native/base/input_file.hpp"
#include "native/base/memory_budget.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace crossgrain::toml_input {

std::string read_text_file(const std::string& file, const std::string& expected,
                           std::stop_token stop) {
    InputFile input(file, expected, std::move(stop));
    std::string text;
    std::vector<char> block(std::size_t{1} << 16);
    while (const std::size_t got = input.read(block)) {
        text.append(block.data(), got);
        if (text.size() > longest_file) {
            throw CaseError(
                {.file = file,
                 .problem = "is too long",
                 .expected = fmt::format("{} of at most {}", expected, shown_bytes(longest_file))});
        }
    }
    if (const auto reason = why_not_text(text)) {
        throw CaseError(
            {.file = file, .problem = *reason, .expected = fmt::format("{} in UTF-8", expected)});
    }
    return text;
}

}  // namespace crossgrain::toml_input
