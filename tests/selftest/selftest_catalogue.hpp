// What `crossgrain selftest` plants and what it must not object to, as data: every *.toml of one
// directory (defects; its README.md lists the keys).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::selftest {

/// Where a defect is planted. All but the last three are replacements of a text.
enum class DefectKind {
    scene,      ///< in the case file of one code
    input,      ///< in an input file generated for one code
    reading,    ///< in the reading of a model's rules that one code follows
    reference,  ///< in a file of published values
    frames,     ///< between one code and the estimators
    results,    ///< in what the estimators of one code found
    borrowed    ///< one code hands on the frames of another
};

/// `from` stands in a text exactly as written; every occurrence becomes `to`. An empty `from` is
/// the whole text.
struct TextEdit {
    std::string from, to;
};

struct Defect {
    std::string name;
    DefectKind kind = DefectKind::scene;
    std::string code;         ///< that carries it; "published" for references
    std::string file;         ///< of an input, a reading or published values, by its name
    TextEdit edit;            ///< kinds that replace a text
    std::string filter;       ///< kind frames: see selftest_frames.hpp
    std::string lender;       ///< kind borrowed: whose frames they are
    std::string spoiled;      ///< kind results: the measurement
    double factor = 1;        ///< kind results: of its value ...
    double error_factor = 1;  ///< ... and of its standard error
    /// The file with the defect must not be read at all; else an error of its reader is an error of
    /// the catalogue.
    bool refused = false;
    std::vector<std::string> shows_in;  ///< observables a right answer names; empty: any
    std::string place;                  ///< "contact.toml:12", for messages
};

/// Defects that are planted in one case, among the same codes.
struct DefectGroup {
    std::string case_name;           ///< of the catalogue, or path of a case file
    std::vector<std::string> codes;  ///< that take part
    /// Runs of each code under other names and with other seeds, for cases whose checks are
    /// statistical and which one code alone can run: a majority to be compared with.
    int peers = 0;
    std::vector<Defect> defects;
};

/// A comparison between runs of which nothing is wrong: a code against itself with other seeds, or
/// against something certified to be equivalent.
struct NullComparison {
    std::string case_name, code;
    std::string against;           ///< a code; the same one if left out of the file
    std::optional<TextEdit> edit;  ///< of the case file of `against`: an equivalent choice
    int rounds = 1;                ///< each with seeds of its own
    std::string place;
};

struct SelftestCatalogue {
    std::vector<DefectGroup> groups;
    std::vector<NullComparison> nulls;

    [[nodiscard]] std::size_t defect_count() const;
};

/// Reads every *.toml of the directory (not below it); case files are looked up from it. Throws
/// CaseError for unknown keys, codes or kinds, and for a directory without defects.
[[nodiscard]] SelftestCatalogue load_selftest(const std::filesystem::path& directory);

[[nodiscard]] std::string to_string(DefectKind kind);

/// Throws CaseError, naming `place`, if `from` does not occur: a defect that is no longer planted
/// must not count as caught.
[[nodiscard]] std::string edited(const std::string& text, const TextEdit& edit,
                                 const std::string& place);

/// A tenth of the null comparisons, and of each group the first defect of every kind.
[[nodiscard]] SelftestCatalogue shortened(SelftestCatalogue catalogue);

}  // namespace crossgrain::selftest
