#pragma once
#include <Eigen/Core>

/// Dense decompositions, compiled once for all tests.
namespace blossom::test {

/// The shortest of the least-squares solutions of a x = b, by singular values; those below `threshold` times the largest
/// count as 0.
Eigen::MatrixXd shortestSolution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double threshold = 1e-12);

/// An orthonormal basis, in columns, of what `a` maps to 0: singular values up to `zero` count as 0.
Eigen::MatrixXd nullSpace(const Eigen::MatrixXd& a, double zero);

/// The orthogonal factor of a = q r.
Eigen::MatrixXd orthogonalFactor(const Eigen::MatrixXd& a);

}  // namespace blossom::test
