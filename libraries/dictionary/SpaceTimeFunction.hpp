#pragma once

#include "dictionary/Dictionary.hpp"
#include "expression/Expression.hpp"

#include <span>
#include <vector>

namespace isph
{

/// A value of x, y, z, t with one or three components, as dictionaries give it:
/// uniform 0 | uniform (1 0 0) | expression "sin(x)" | expression ("..." "..." "...") | table "file.csv".
class SpaceTimeFunction
{
public:
    static SpaceTimeFunction uniform(std::vector<double> values);

    /// From expressions, one a component.
    explicit SpaceTimeFunction(std::vector<Expression> expressions);

    /// From a table: a coordinate column (x, y, z or t, read off the header) and one column per component,
    /// interpolated by natural cubic splines; outside of the table's range the ends are held.
    struct Table;
    explicit SpaceTimeFunction(Table table);

    ~SpaceTimeFunction();
    SpaceTimeFunction(SpaceTimeFunction&&) noexcept;
    SpaceTimeFunction& operator=(SpaceTimeFunction&&) noexcept;

    int components() const;
    bool isUniform() const; ///< the same at every point and time
    bool dependsOnTime() const;

    double operator()(int component, double x, double y, double z, double t) const;

    /// One component at many points of one time.
    void evaluate(int component, std::span<const double> x, std::span<const double> y, std::span<const double> z,
                  double t, std::span<double> values) const;

private:
    std::vector<double> uniform_;
    std::vector<Expression> expressions_;
    std::unique_ptr<Table> table_;
};

/// Reads the function of a key. A bare number or vector counts as uniform.
/// \param components 1 or 3
/// \param constants names besides the scalar entries of the dictionary and its parents (nu, rho)
/// \param folder where table files are looked for (the case)
/// \throws Error(input) at the entry.
SpaceTimeFunction readFunction(const Dictionary& dictionary, std::string_view key, int components,
                               const std::vector<std::pair<std::string, double>>& constants,
                               const std::filesystem::path& folder);

} // namespace isph
