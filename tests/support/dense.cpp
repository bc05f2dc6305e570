#include "support/dense.h"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace blossom::test {

using Eigen::MatrixXd;

MatrixXd shortestSolution(const MatrixXd& a, const MatrixXd& b, double threshold) {
  Eigen::JacobiSVD<MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(threshold);
  return svd.solve(b);
}

MatrixXd nullSpace(const MatrixXd& a, double zero) {
  const Eigen::JacobiSVD<MatrixXd> svd(a, Eigen::ComputeFullV);
  Eigen::Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()[rank] > zero) ++rank;
  return svd.matrixV().rightCols(a.cols() - rank);
}

MatrixXd orthogonalFactor(const MatrixXd& a) { return a.householderQr().householderQ(); }

}  // namespace blossom::test
