#include "vtkOutput/writeVti.hpp"

#include "core/FileDescriptor.hpp"

#include <cassert>
#include <cerrno>
#include <system_error>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

namespace isph
{

namespace
{

/// Points along an axis of the image.
int imageCount(const Axis& axis) { return axis.count + (axis.active() && axis.periodic() ? 1 : 0); }

/// An axis left out has no spacing of its own, but an image needs one: that of the axes in use.
double imageSpacing(const Lattice& lattice, int direction)
{
    const Axis& axis = lattice.axis(direction);
    return axis.active() ? axis.spacing() : lattice.activeAxis(0).spacing();
}

vtkNew<vtkImageData> emptyImage(const Lattice& lattice)
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(imageCount(lattice.axis(0)), imageCount(lattice.axis(1)), imageCount(lattice.axis(2)));
    image->SetOrigin(lattice.axis(0).coordinate(0), lattice.axis(1).coordinate(0), lattice.axis(2).coordinate(0));
    image->SetSpacing(imageSpacing(lattice, 0), imageSpacing(lattice, 1), imageSpacing(lattice, 2));
    return image;
}

/// Calls visit(point of the image, point of the lattice, periods passed along each axis) in the order of the image.
template<class Visit>
void forEachImagePoint(const Lattice& lattice, Visit visit)
{
    const std::array<int, 3> count{lattice.axis(0).count, lattice.axis(1).count, lattice.axis(2).count};
    vtkIdType target = 0;
    for (int iz = 0; iz < imageCount(lattice.axis(2)); ++iz)
    {
        for (int iy = 0; iy < imageCount(lattice.axis(1)); ++iy)
        {
            const auto row = static_cast<std::size_t>(iz % count[2]) * static_cast<std::size_t>(count[1]) +
                             static_cast<std::size_t>(iy % count[1]);
            const std::size_t begin = row * static_cast<std::size_t>(count[0]);
            for (int ix = 0; ix < imageCount(lattice.axis(0)); ++ix)
            {
                visit(target++, begin + static_cast<std::size_t>(ix % count[0]),
                      std::array<int, 3>{ix / count[0], iy / count[1], iz / count[2]});
            }
        }
    }
}

template<class Array>
void addArray(const ImageArray& source, const Lattice& lattice, vtkImageData& image)
{
    using Value = typename Array::ValueType;
    const RealField& field = *source.values;
    assert(field.size() == lattice.points());

    vtkNew<Array> array;
    array->SetName(source.name.c_str());
    if (field.components() == 1)
    {
        array->SetNumberOfValues(image.GetNumberOfPoints());
        forEachImagePoint(lattice,
                          [&](vtkIdType target, std::size_t n, const std::array<int, 3>& periods)
                          {
                              double value = field[0][n];
                              for (std::size_t d = 0; d < 3; ++d) { value += periods[d] * source.periodGain[d]; }
                              array->SetValue(target, static_cast<Value>(value));
                          });
    }
    else
    {
        assert(field.components() == lattice.dimensions());
        array->SetNumberOfComponents(3);
        array->SetNumberOfTuples(image.GetNumberOfPoints());
        array->Fill(0);
        forEachImagePoint(lattice,
                          [&](vtkIdType target, std::size_t n, const std::array<int, 3>&)
                          {
                              for (int d = 0; d < field.components(); ++d)
                              {
                                  array->SetTypedComponent(target, lattice.direction(d),
                                                           static_cast<Value>(field[d][n]));
                              }
                          });
    }
    image.GetPointData()->AddArray(array);
}

void addTime(double time, vtkImageData& image)
{
    // The name that ParaView's readers look for.
    vtkNew<vtkDoubleArray> array;
    array->SetName("TimeValue");
    array->InsertNextValue(time);
    image.GetFieldData()->AddArray(array);
}

/// What the machine said; VTK's own codes are few here.
int reasonOf(unsigned long code)
{
    if (code == vtkErrorCode::OutOfDiskSpaceError) { return ENOSPC; }
    return code != vtkErrorCode::NoError && code < vtkErrorCode::FirstVTKErrorCode ? static_cast<int>(code) : EIO;
}

} // namespace

void writeVti(const std::filesystem::path& file, const Lattice& lattice, double time,
              std::span<const ImageArray> arrays, const VtiFormat& format)
{
    const auto image = emptyImage(lattice);
    addTime(time, *image);
    for (const ImageArray& array : arrays)
    {
        if (format.singlePrecision) { addArray<vtkFloatArray>(array, lattice, *image); }
        else { addArray<vtkDoubleArray>(array, lattice, *image); }
    }

    // VTK would print what we throw.
    vtkObject::GlobalWarningDisplayOff();
    const std::filesystem::path temporary = temporaryName(file);
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(temporary.c_str());
    writer->SetInputData(image);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetHeaderTypeToUInt64();
    if (format.compressed) { writer->SetCompressorTypeToZLib(); }
    else { writer->SetCompressorTypeToNone(); }
    try
    {
        const bool written = writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
        if (!written) { throwRefused(file, "could not be written", reasonOf(writer->GetErrorCode())); }
        syncToDisk(temporary);
        std::filesystem::rename(temporary, file);
    }
    catch (...)
    {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw;
    }
}

} // namespace isph
