#include "geometry/five_point.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>
#include <cstddef>

namespace glide {
namespace {

struct Monomial {
  int x, y, z;
};

/// Ten cubic monomials, then the ten that span the quotient ring.
constexpr int kMonomialCount = 20;
constexpr std::array<Monomial, kMonomialCount> kMonomials{
    {{3, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 3, 0}, {2, 0, 1}, {1, 1, 1}, {0, 2, 1},
     {1, 0, 2}, {0, 1, 2}, {0, 0, 3}, {2, 0, 0}, {1, 1, 0}, {0, 2, 0}, {1, 0, 1},
     {0, 1, 1}, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
constexpr int kFirstQuadratic = 10;  // polynomials of degree 2 use the monomials from here on,
constexpr int kFirstLinear = 16;     // those of degree 1 from here on

using Products = std::array<std::array<int, kMonomialCount>, kMonomialCount>;

/// Index of the product of two monomials; -1 where its degree is above three.
constexpr Products makeProducts() {
  Products products{};
  for (std::size_t i = 0; i < kMonomials.size(); ++i) {
    for (std::size_t j = 0; j < kMonomials.size(); ++j) {
      products[i][j] = -1;
      for (std::size_t k = 0; k < kMonomials.size(); ++k) {
        const bool same = kMonomials[k].x == kMonomials[i].x + kMonomials[j].x &&
                          kMonomials[k].y == kMonomials[i].y + kMonomials[j].y &&
                          kMonomials[k].z == kMonomials[i].z + kMonomials[j].z;
        if (same) products[i][j] = static_cast<int>(k);
      }
    }
  }
  return products;
}
constexpr Products kProducts = makeProducts();

using Polynomial = Eigen::Matrix<double, kMonomialCount, 1>;

/// Product of polynomials that use the monomials from kFirstA and kFirstB on.
template <int kFirstA, int kFirstB>
Polynomial multiply(const Polynomial& a, const Polynomial& b) {
  Polynomial out = Polynomial::Zero();
  for (int i = kFirstA; i < kMonomialCount; ++i) {
    const auto& row = kProducts[static_cast<std::size_t>(i)];
    for (int j = kFirstB; j < kMonomialCount; ++j)
      out[row[static_cast<std::size_t>(j)]] += a[i] * b[j];
  }
  return out;
}

using PolynomialMatrix = std::array<std::array<Polynomial, 3>, 3>;
using NullSpace = Eigen::Matrix<double, 9, 4>;
using Constraints = Eigen::Matrix<double, 10, kMonomialCount>;

/// The four matrices E_k with b^T E_k a = 0 for all five pairs, row by row in the columns.
NullSpace epipolarNullSpace(const FivePairs& pairs) {
  Eigen::Matrix<double, 9, 5> rows;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (int r = 0; r < 3; ++r) {
      rows.col(static_cast<Eigen::Index>(i)).segment<3>(3 * r) = pairs[i]->b.f[r] * pairs[i]->a.f;
    }
  }
  const Eigen::HouseholderQR<Eigen::Matrix<double, 9, 5>> qr(rows);
  const Eigen::Matrix<double, 9, 9> Q = qr.householderQ();
  return Q.rightCols<4>();
}

/// E = x E_0 + y E_1 + z E_2 + E_3.
PolynomialMatrix essentialPolynomial(const NullSpace& basis) {
  PolynomialMatrix E;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      E[r][c].setZero();
      E[r][c].tail<4>() = basis.row(static_cast<Eigen::Index>(3 * r + c)).transpose();
    }
  }
  return E;
}

/// Determinant: first row times its cofactors.
Polynomial determinant(const PolynomialMatrix& E) {
  const auto minor = [&](std::size_t c1, std::size_t c2) -> Polynomial {
    return multiply<kFirstLinear, kFirstLinear>(E[1][c1], E[2][c2]) -
           multiply<kFirstLinear, kFirstLinear>(E[1][c2], E[2][c1]);
  };
  return multiply<kFirstQuadratic, kFirstLinear>(minor(1, 2), E[0][0]) -
         multiply<kFirstQuadratic, kFirstLinear>(minor(0, 2), E[0][1]) +
         multiply<kFirstQuadratic, kFirstLinear>(minor(0, 1), E[0][2]);
}

/// det E = 0 and 2 E E^T E - trace(E E^T) E = 0.
Constraints essentialConstraints(const PolynomialMatrix& E) {
  PolynomialMatrix gram;  // E E^T, then less half of its trace on the diagonal
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      gram[r][c].setZero();
      for (std::size_t k = 0; k < 3; ++k) {
        gram[r][c] += multiply<kFirstLinear, kFirstLinear>(E[r][k], E[c][k]);
      }
    }
  }
  const Polynomial half_trace = 0.5 * (gram[0][0] + gram[1][1] + gram[2][2]);
  for (std::size_t r = 0; r < 3; ++r) gram[r][r] -= half_trace;

  Constraints out;
  out.row(0) = determinant(E).transpose();
  Eigen::Index row = 1;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      Polynomial sum = Polynomial::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        sum += multiply<kFirstQuadratic, kFirstLinear>(gram[r][k], E[k][c]);
      }
      out.row(row++) = sum.transpose();
    }
  }
  return out;
}

/// Multiplication by x in the quotient ring: (M b)_i = x b_i for the basis monomials b of a
/// solution.
Eigen::Matrix<double, 10, 10> actionMatrix(const Constraints& constraints) {
  const Eigen::Matrix<double, 10, 10> reduced =
      constraints.leftCols<10>().partialPivLu().solve(constraints.rightCols<10>());
  constexpr int kX = 16;
  Eigen::Matrix<double, 10, 10> M = Eigen::Matrix<double, 10, 10>::Zero();
  for (int i = 0; i < 10; ++i) {
    const int product = kProducts[kX][static_cast<std::size_t>(kFirstQuadratic + i)];
    if (product < kFirstQuadratic) {
      M.row(i) = -reduced.row(product);
    } else {
      M(i, product - kFirstQuadratic) = 1.0;
    }
  }
  return M;
}

}  // namespace

std::vector<Mat3d> essentialsFromFivePairs(const FivePairs& pairs) {
  const NullSpace basis = epipolarNullSpace(pairs);
  const Eigen::Matrix<double, 10, 10> M =
      actionMatrix(essentialConstraints(essentialPolynomial(basis)));
  if (!M.allFinite()) return {};
  const Eigen::EigenSolver<Eigen::Matrix<double, 10, 10>> solver(M);
  if (solver.info() != Eigen::Success) return {};

  std::vector<Mat3d> essentials;
  for (Eigen::Index i = 0; i < 10; ++i) {
    if (solver.eigenvalues()[i].imag() != 0.0) continue;
    const Eigen::Matrix<double, 10, 1> b = solver.eigenvectors().col(i).real();
    const Eigen::Matrix<double, 9, 1> e = basis * b.tail<4>();  // (x, y, z, 1) up to scale
    const double norm = e.norm();
    if (!(norm > 0.0) || !std::isfinite(norm)) continue;
    essentials.push_back(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(e.data()) /
                         norm);
  }
  return essentials;
}

}  // namespace glide
