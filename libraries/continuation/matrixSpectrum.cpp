#include "continuation/matrixSpectrum.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <stdexcept>
#include <string>

namespace isph
{

std::vector<std::complex<double>> eigenvaluesOf(std::span<const double> matrix, std::size_t n)
{
    if (n == 0) { return {}; }
    const bool finite = std::ranges::all_of(matrix, [](double value) { return std::isfinite(value); });
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto size = static_cast<Eigen::Index>(n);
    const Eigen::MatrixXd values = Eigen::Map<const Rows>(matrix.data(), size, size);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(finite ? values : Eigen::MatrixXd::Zero(size, size), false);
    if (!finite || solver.info() != Eigen::Success)
    {
        throw std::runtime_error("the eigenvalues of a matrix of " + std::to_string(n) + " rows were not found");
    }
    const auto& found = solver.eigenvalues();
    return {found.data(), found.data() + found.size()};
}

} // namespace isph
