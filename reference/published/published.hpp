// Numbers and trends from the literature: value, error, where they stand and how they were
// obtained.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace crossgrain::published {

struct PublishedValue {
    std::string id;        ///< "<file>/<name>", e.g. "taguchi-1995/slope-low-layers"
    std::string quantity;  ///< what it is, in words
    double value = 0;      ///< reduced units of the paper
    double error = 0;      ///< standard error as published; 0 if none is stated
    std::string trend;     ///< instead of a value: "constant", "increasing" or "decreasing"
    std::string source;    ///< author, title, journal or preprint number
    std::string place;     ///< figure, section or page
    std::string obtained;  ///< read from text, from a figure, computed from stated numbers
};

class PublishedValues {
  public:
    /// Reads every *.toml of a directory. Throws CaseError for a file that is not as expected.
    explicit PublishedValues(const std::filesystem::path& directory);

    /// The value with this id, or nothing (the verdict is then `no_reference`).
    [[nodiscard]] std::optional<PublishedValue> find(const std::string& id) const;
    [[nodiscard]] std::size_t size() const noexcept { return values_.size(); }

  private:
    std::map<std::string, PublishedValue> values_;
};

}  // namespace crossgrain::published
