#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/progress.h"
#include "kernel/edit/place_row.h"

namespace blossom::sweep {

/// A change of some poles of a factor.
struct PoleChange {
  std::vector<std::size_t> pole;  ///< increasing
  Eigen::MatrixXd by;             ///< a row for each of them
  double residual = 0;            ///< largest length by which a place misses what is wanted there
  double swing = 0;               ///< largest change of a pole beside the largest wanted by a place that is tied to it
};

/// The smallest change of poles (in the sum of squares) by which the value of a factor changes at some places as `wanted`
/// and not at all at others.
///
/// One place: dC = N / sum(N^2) * wanted (Piegl & Tiller, The NURBS Book, section 11.2). Several: with the rows A of the
/// places and P of the pins, the minimum-norm solution of min |A dC - wanted| over all dC with P dC = 0: A is projected on
/// the null space of P, then solved by its singular values. Pins therefore hold even where the places contradict them or
/// each other; those are met by least squares then, and `residual` says by how much they miss. Places with the same row,
/// such as copies around a motion on its trajectory, count as one place with their mean and their weight: the solution is
/// the same, and the singular values of rounding that their difference would have do not arise. Places and pins that share
/// no poles, directly or over others, are solved for themselves. Singular values below a millionth of the largest row count
/// as 0. @param wanted a row for each moved place
/// O(n m^2) for m places and pins that are tied together and the n poles they touch. @throws Error Cancelled; Degenerate
/// when the change would not be finite, as for values wanted whose squares are beyond all numbers.
PoleChange leastChange(std::span<const PlaceRow> moved, const Eigen::MatrixXd& wanted, std::span<const PlaceRow> pins,
                       const Progress& = Progress::none());

/// Applies a change of Euclidean poles to a trajectory, whose weights stay. @returns how many poles are other than before
std::size_t applyChange(const PoleChange&, Curve& trajectory);
/// The same for a surface; rows of a closed motion that repeat others are repeated again, bit for bit.
std::size_t applyChange(const PoleChange&, Surface&, double closure);

}  // namespace blossom::sweep
