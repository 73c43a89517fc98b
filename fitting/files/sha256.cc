// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/files/sha256.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace clothfit {
namespace {

using Word = std::uint32_t;

// Sec. 4.2.2 and 5.3.3: the first 32 bits of the fractional parts of the cube roots of the first 64
// primes, and of the square roots of the first 8. A long double of 64 bits holds more than enough.
struct Constants {
  std::array<Word, 64> rounds;
  std::array<Word, 8> start;

  Constants() {
    std::size_t count = 0;
    for (int n = 2; count < rounds.size(); ++n) {
      bool is_prime = true;
      for (int d = 2; d * d <= n; ++d) is_prime = is_prime && n % d != 0;
      if (!is_prime) continue;
      rounds[count] = Fraction(std::cbrt(static_cast<long double>(n)));
      if (count < start.size()) start[count] = Fraction(std::sqrt(static_cast<long double>(n)));
      ++count;
    }
  }
  static Word Fraction(long double root) {
    return static_cast<Word>((root - std::floor(root)) * 0x1p32L);
  }
};

Word Turn(Word word, int bits) { return (word >> bits) | (word << (32 - bits)); }

// Sec. 6.2.2.
void AddBlock(const Constants& constants, const unsigned char* block, std::array<Word, 8>* hash) {
  std::array<Word, 64> w;
  for (int t = 0; t < 16; ++t) {
    w[t] = 0;
    for (int k = 0; k < 4; ++k) w[t] = (w[t] << 8) | block[4 * t + k];
  }
  for (int t = 16; t < 64; ++t) {
    const Word s0 = Turn(w[t - 15], 7) ^ Turn(w[t - 15], 18) ^ (w[t - 15] >> 3);
    const Word s1 = Turn(w[t - 2], 17) ^ Turn(w[t - 2], 19) ^ (w[t - 2] >> 10);
    w[t] = s1 + w[t - 7] + s0 + w[t - 16];
  }
  auto [a, b, c, d, e, f, g, h] = *hash;
  for (int t = 0; t < 64; ++t) {
    const Word sum1 = Turn(e, 6) ^ Turn(e, 11) ^ Turn(e, 25), choice = (e & f) ^ (~e & g);
    const Word t1 = h + sum1 + choice + constants.rounds[t] + w[t];
    const Word sum0 = Turn(a, 2) ^ Turn(a, 13) ^ Turn(a, 22), most = (a & b) ^ (a & c) ^ (b & c);
    h = g;
    g = f;
    f = e;
    e = d + t1;
    d = c;
    c = b;
    b = a;
    a = t1 + sum0 + most;
  }
  const std::array<Word, 8> now = {a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < now.size(); ++i) (*hash)[i] += now[i];
}

}  // namespace

std::string Sha256(std::string_view message) {
  static const Constants constants;
  std::string padded(message);  // sec. 5.1.1
  padded.push_back('\x80');
  while (padded.size() % 64 != 56) padded.push_back('\0');
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(message.size());
  for (int k = 7; k >= 0; --k) padded.push_back(static_cast<char>((bits >> (8 * k)) & 0xff));
  std::array<Word, 8> hash = constants.start;
  for (std::size_t i = 0; i < padded.size(); i += 64)
    AddBlock(constants, reinterpret_cast<const unsigned char*>(padded.data()) + i, &hash);
  std::string digits;
  for (const Word word : hash) {
    char text[9];
    std::snprintf(text, sizeof(text), "%08x", word);
    digits += text;
  }
  return digits;
}

}  // namespace clothfit
