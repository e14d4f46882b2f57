#pragma once

#include "lattice/Lattice.hpp"
#include "linear/SparseMatrix.hpp"
#include "operators/KernelSamples.hpp"
#include "poisson/BoundedPoisson.hpp"

#include <vector>

namespace isph
{

/// The ends of a box of walls: Neumann where an axis is bounded.
std::array<AxisEnds, 3> wallEnds(const Lattice& lattice);

/// What a Laplacian over lattice neighbours makes of the ends of a box: neighbours beyond walls are mirror particles
/// (MirroredAxis), and what is prescribed there, slopes or values, is on the right-hand side.
class MirrorData
{
public:
    /// \param samples with LaplacianForm::morris \throws Error(input) without origin if an axis has too few points
    MirrorData(const Lattice& lattice, const KernelSamples& samples, const std::array<AxisEnds, 3>& ends);

    /// Minus the source, less what the data add to minus the Laplacian. Faces without data have zeros.
    /// \return without a Dirichlet end, by how much the mean of the source exceeds what flows through the walls, which
    /// no phi can balance and which is taken out; else 0
    double rightHandSide(std::span<const double> source, const WallData& walls, std::span<double> result);

    /// Of the trapezoid rule, halved on walls; empty in periodic boxes, where all are 1.
    std::span<const double> weights() const { return weights_; }

    /// Whether constants are in the null space.
    bool constantMode() const { return constantMode_; }

    /// Points whose value is given. Their right-hand side is the value times the diagonal [1/m^2] of all points inside.
    std::span<const std::size_t> fixed() const { return fixed_; }
    double diagonal() const { return diagonal_; }

protected:
    /// \param withMatrix whether to make matrix, too
    MirrorData(const Lattice& lattice, const KernelSamples& samples, const std::array<AxisEnds, 3>& ends,
               bool withMatrix);

    SparseMatrix matrix_;

private:
    struct Assembly;

    void weigh(const Assembly& assembly);

    SparseMatrix ofData_; ///< what the data of all faces add
    AlignedVector<double> weights_;
    double totalWeight_ = 0;
    bool constantMode_ = true;
    double diagonal_ = 1;
    std::vector<std::size_t> fixed_;
    std::array<std::array<std::size_t, 2>, 3> firstOfFace_{}; ///< in data_, by direction and end
    std::array<std::size_t, 3> facePoints_{};
    AlignedVector<double> data_;
    AlignedVector<double> supplied_;
};

/// The linear system of classical ISPH (Fourtakas et al. 2021, eqs 4.3 to 4.6, with the factor and the signs of
/// docs/theory/errata.md): minus the Morris Laplacian over lattice neighbours,
///
///     matrix(a, b) = 2 V x.grad W/x^2,   matrix(a, a) = - sum over b of matrix(a, b),
///
/// by the weights of KernelSamples, in boxes with any mix of periodic, Neumann and Dirichlet ends. A mirror particle
/// adds to the entry of the point it mirrors. Points whose value is given have a row of their diagonal only.
///
/// The matrix is symmetric in the inner product with the weights, and positive but for the constant.
class MorrisSystem : public MirrorData
{
public:
    /// \throws Error(input) without origin if the matrix has more entries than can be counted or an axis too few points
    MorrisSystem(const Lattice& lattice, const KernelSamples& samples, const std::array<AxisEnds, 3>& ends)
        : MirrorData(lattice, samples, ends, true)
    {
    }

    const SparseMatrix& matrix() const { return matrix_; } ///< [1/m^2]
};

/// \throws Error(input) without origin if the matrix has more entries than can be counted
void requireCountable(const Lattice& lattice, const KernelSamples& samples);

/// Bytes of the matrix, at most.
double morrisSystemBytes(const Lattice& lattice, std::size_t neighbours);

/// Bytes of what carries the data of walls to the points they reach (MirrorData), at most where supports fit into the
/// box.
double mirrorDataBytes(const Lattice& lattice, std::size_t neighbours);

} // namespace isph
