// Which instruction sets the kernels may use that are chosen at run time (Highway).
#pragma once

namespace crossgrain {

/// Whether kernels use AVX-512 on this machine.
[[nodiscard]] bool has_avx512();

/// While it lives, kernels are chosen as on a machine without AVX-512: what its user has can be
/// measured on this one. Of the whole program; engines made before keep their kernels, and none
/// must be made by another thread meanwhile.
class WithoutAvx512 {
  public:
    WithoutAvx512();
    ~WithoutAvx512();
    WithoutAvx512(const WithoutAvx512&) = delete;
    WithoutAvx512& operator=(const WithoutAvx512&) = delete;
};

}  // namespace crossgrain
