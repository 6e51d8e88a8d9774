// Digests that name runs, prepared states and programs by their content.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace crossgrain {

/// SHA-256 of bytes that come piece by piece.
class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::string_view bytes);
    /// 64 hexadecimal digits. To be called once, at the end.
    [[nodiscard]] std::string hex();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// SHA-256 of a text, 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view text);

}  // namespace crossgrain
