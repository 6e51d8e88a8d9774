#include "tests/selftest/selftest_catalogue.hpp"

#include "adapters/registry/codes.hpp"

#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace crossgrain::selftest {
namespace {

namespace fs = std::filesystem;
using toml_input::Range;
using toml_input::TomlTable;

const std::array<std::string, 7> kind_words{"scene",  "input",   "reading", "reference",
                                            "frames", "results", "borrowed"};

/// A path from the directory of the catalogue, or a name of the catalogue of cases.
std::string case_of(const TomlTable& t, const fs::path& directory) {
    const std::string given = t.text("case");
    return given.ends_with(".toml") ? (directory / given).string() : given;
}

std::string code_of(const TomlTable& t, const char* key) {
    const std::string name = t.text(key);
    try {
        (void)adapters::select_codes({name});
    } catch (const CaseError& error) {
        throw t.error(key, error.details().problem, error.details().got, error.details().expected,
                      error.details().hint);
    }
    return name;
}

TextEdit edit_of(const TomlTable& t) {
    return {.from = t.has("replace") ? t.prose("replace") : "", .to = t.prose("with")};
}

Defect read_defect(const TomlTable& t) {
    Defect defect{.name = t.name("name"),
                  .kind = static_cast<DefectKind>(t.choice("kind", kind_words)),
                  .place = fmt::format("{}:{}", fs::path(t.file()).filename().string(), t.line())};
    defect.code = defect.kind == DefectKind::reference ? "published" : code_of(t, "code");
    switch (defect.kind) {
    case DefectKind::input:
    case DefectKind::reading:
    case DefectKind::reference:
        defect.file = t.text("file");
        [[fallthrough]];
    case DefectKind::scene:
        defect.edit = edit_of(t);
        break;
    case DefectKind::frames:
        defect.filter = t.text("filter");
        break;
    case DefectKind::borrowed:
        defect.lender = code_of(t, "from");
        break;
    case DefectKind::results:
        defect.spoiled = t.text("measurement");
        defect.factor = t.optional_number("factor", Range::any()).value_or(1);
        defect.error_factor = t.optional_number("error_factor", Range::positive()).value_or(1);
        break;
    }
    if (t.has("refused")) defect.refused = t.boolean("refused");
    if (t.has("shows_in")) defect.shows_in = t.texts("shows_in");
    t.reject_unknown_keys();
    return defect;
}

DefectGroup read_group(const TomlTable& t, const fs::path& directory) {
    DefectGroup group{.case_name = case_of(t, directory), .codes = t.texts("codes")};
    try {
        (void)adapters::select_codes(group.codes);
    } catch (const CaseError& error) {
        throw t.error("codes", error.details().problem, error.details().got,
                      error.details().expected, error.details().hint);
    }
    if (t.has("peers")) group.peers = static_cast<int>(t.integer("peers", 0, 100));
    for (const TomlTable& entry : t.tables("defect"))
        group.defects.push_back(read_defect(entry));
    for (const auto& defect : group.defects) {
        const auto& codes = group.codes;
        if (defect.kind == DefectKind::reference) continue;
        if (std::find(codes.begin(), codes.end(), defect.code) != codes.end()) continue;
        throw t.error("codes", "lacks the code of a defect", defect.code,
                      "all codes that carry one");
    }
    t.reject_unknown_keys();
    return group;
}

NullComparison read_null(const TomlTable& t, const fs::path& directory) {
    NullComparison null{.case_name = case_of(t, directory),
                        .code = code_of(t, "code"),
                        .rounds = static_cast<int>(t.integer("rounds", 1, 1'000'000)),
                        .place =
                            fmt::format("{}:{}", fs::path(t.file()).filename().string(), t.line())};
    null.against = t.has("against") ? code_of(t, "against") : null.code;
    if (t.has("with")) null.edit = edit_of(t);
    t.reject_unknown_keys();
    return null;
}

void refuse_equal_names(const SelftestCatalogue& catalogue) {
    std::set<std::string> names;
    for (const auto& group : catalogue.groups) {
        for (const auto& defect : group.defects) {
            if (names.insert(defect.name).second) continue;
            throw CaseError({.file = defect.place,
                             .key = "defect.name",
                             .problem = "is taken",
                             .got = fmt::format("\"{}\"", defect.name),
                             .expected = "a name of its own"});
        }
    }
}

}  // namespace

std::size_t SelftestCatalogue::defect_count() const {
    std::size_t count = 0;
    for (const auto& group : groups)
        count += group.defects.size();
    return count;
}

SelftestCatalogue load_selftest(const fs::path& directory) {
    std::error_code error;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(directory, error)) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    SelftestCatalogue catalogue;
    for (const auto& file : files) {
        const toml::table root = toml_input::parse_toml_file(file.string());
        const TomlTable t(file.string(), "", {&root});
        for (const TomlTable& entry : t.tables("group"))
            catalogue.groups.push_back(read_group(entry, directory));
        for (const TomlTable& entry : t.tables("null"))
            catalogue.nulls.push_back(read_null(entry, directory));
        t.reject_unknown_keys();
    }
    refuse_equal_names(catalogue);
    if (catalogue.defect_count() == 0) {
        throw CaseError({.file = directory.string(),
                         .problem = "holds no defects to plant",
                         .expected = "the files of tests/selftest/defects",
                         .hint = "name their directory with --defects"});
    }
    return catalogue;
}

std::string to_string(DefectKind kind) {
    return kind_words[static_cast<std::size_t>(kind)];
}

std::string edited(const std::string& text, const TextEdit& edit, const std::string& place) {
    if (edit.from.empty()) return edit.to;
    std::string result;
    std::size_t begin = 0;
    for (std::size_t at = text.find(edit.from); at != std::string::npos;
         at = text.find(edit.from, begin)) {
        result.append(text, begin, at - begin);
        result += edit.to;
        begin = at + edit.from.size();
    }
    if (begin == 0) {
        throw CaseError({.file = place,
                         .key = "replace",
                         .problem = "is not in the text it is about",
                         .got = fmt::format("\"{}\"", edit.from),
                         .expected = "a text as it stands there"});
    }
    return result.append(text, begin, std::string::npos);
}

SelftestCatalogue shortened(SelftestCatalogue catalogue) {
    for (auto& null : catalogue.nulls)
        null.rounds = std::max(1, null.rounds / 10);
    for (auto& group : catalogue.groups) {
        std::map<DefectKind, int> seen;
        std::erase_if(group.defects, [&](const auto& defect) { return seen[defect.kind]++ > 0; });
    }
    return catalogue;
}

}  // namespace crossgrain::selftest
