// Names of the files of a report that are made from names in its document.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain::reports {

/// Gives out file names, no two of them alike, also where files do not tell upper from lower case.
class FileNames {
  public:
    /// "case-code-variant-name.png" from its parts: empty ones left out, anything but letters,
    /// digits and "=._+-" becomes "_". The same parts again, or parts that only look the same, get
    /// "-2", "-3", ... before the extension.
    [[nodiscard]] std::string next(const std::vector<std::string>& parts,
                                   std::string_view extension);

  private:
    std::set<std::string> taken_;
};

}  // namespace crossgrain::reports
