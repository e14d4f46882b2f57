// Reads every file of a folder as the fuzzer would: what once was found stays fixed.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv)
{
    int count = 0;
    for (int i = 1; i < argc; ++i)
    {
        for (const auto& file : std::filesystem::directory_iterator(argv[i]))
        {
            std::cout << file.path().filename().string() << std::endl; // flushed: the last name is the culprit
            std::ifstream stream(file.path(), std::ios::binary);
            const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
            LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
            ++count;
        }
    }
    return count > 0 ? 0 : 1;
}
