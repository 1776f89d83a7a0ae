#include "suites/truth/media/density_integral.h"

#include <algorithm>
#include <cmath>

namespace sb {
namespace {

/// Enough to find a kink to a millionth of a piece.
constexpr int kPieceHalvings = 20;

struct Piece {
  double from, to;
  double first, middle, last;  ///< f there
  double sum() const { return (to - from) / 6 * (first + 4 * middle + last); }
};

Piece pieceOf(const Along& f, double from, double to, double first, double last) {
  return {from, to, first, f(0.5 * (from + to)), last};
}

double refined(const Along& f, const Piece& p, double tolerance, int halvings) {
  const double middle = 0.5 * (p.from + p.to);
  const Piece left = pieceOf(f, p.from, middle, p.first, p.middle);
  const Piece right = pieceOf(f, middle, p.to, p.middle, p.last);
  const double halves = left.sum() + right.sum(), change = halves - p.sum();
  if (std::abs(change) <= 15 * tolerance || halvings == 0) return halves + change / 15;
  return refined(f, left, tolerance / 2, halvings - 1) +
         refined(f, right, tolerance / 2, halvings - 1);
}

std::vector<Piece> pieces(const Along& f, const std::vector<double>& ends) {
  std::vector<Piece> all;
  double last = f(ends.front());
  for (size_t i = 0; i + 1 < ends.size(); ++i) {
    const double first = last;
    last = f(ends[i + 1]);
    all.push_back(pieceOf(f, ends[i], ends[i + 1], first, last));
  }
  return all;
}

}  // namespace

double cubicPieces(const Along& f, const std::vector<double>& ends) {
  double sum = 0;
  for (const Piece& p : pieces(f, ends)) sum += p.sum();
  return sum;
}

double adaptiveSimpson(const Along& f, const std::vector<double>& ends, double tolerance,
                       double scale) {
  const std::vector<Piece> all = pieces(f, ends);
  double coarse = 0, sum = 0;
  for (const Piece& p : all) coarse += p.sum();
  const double allowed = tolerance * std::max(1.0, scale * coarse) / (ends.back() - ends.front());
  for (const Piece& p : all) sum += refined(f, p, allowed * (p.to - p.from), kPieceHalvings);
  return sum;
}

}  // namespace sb
