// PCG32 (O'Neill 2014): the same numbers from the same seed on every machine and compiler, which
// std distributions do not promise.
#pragma once

#include <cstdint>

namespace sb {

class Pcg {
 public:
  /// Streams of one seed are independent of one another.
  explicit Pcg(uint64_t seed, uint64_t stream = 0) : m_increment(stream << 1 | 1) {
    next();
    m_state += seed;
    next();
  }
  uint32_t next() {
    const uint64_t old = m_state;
    m_state = old * 6364136223846793005ull + m_increment;
    const uint32_t mixed = uint32_t(((old >> 18) ^ old) >> 27);
    const uint32_t turn = uint32_t(old >> 59);
    return mixed >> turn | mixed << ((32 - turn) & 31);
  }
  /// In [0, 1), a multiple of 2^-32.
  double uniform() { return next() * 0x1p-32; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, count), count > 0; the bias is below count * 2^-32.
  uint32_t below(uint32_t count) { return uint32_t(uint64_t(next()) * count >> 32); }

 private:
  uint64_t m_state = 0;
  uint64_t m_increment;
};

}  // namespace sb
