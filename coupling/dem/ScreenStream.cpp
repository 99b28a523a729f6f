// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/ScreenStream.hpp"

#include <mpi.h>

#include <cstdlib>
#include <stdexcept>

namespace interstice::dem
{

namespace
{

/// The engine inside LIGGGHTS just now; what the end of MPI and of the program can see of it.
ScreenStream* atWork = nullptr;

void announceSilentEnd()
{
    if (atWork)
    {
        atWork->announceEnd();
        atWork = nullptr;
    }
}

int announceAtFinalize(MPI_Comm, int, void*, void*)
{
    announceSilentEnd();
    return MPI_SUCCESS;
}

/// MPI_Finalize first deletes what hangs on MPI_COMM_SELF (MPI 3.1, section 8.7.1). LIGGGHTS
/// finalizes before it exits, and a rank that has exited has mpirun end the others, so a word
/// said at the exit alone can come too late.
bool listenForTheEnd()
{
    int key = MPI_KEYVAL_INVALID;
    MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, announceAtFinalize, &key, nullptr);
    MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr);
    return std::atexit(announceSilentEnd) == 0;
}

} // namespace

ScreenStream::ScreenStream(bool firstRank, const std::string& path)
    : firstRank_(firstRank), path_(firstRank ? path : std::string())
{
    cookie_io_functions_t functions{};
    functions.write = &ScreenStream::write;
    stream_ = fopencookie(this, "w", functions);
    if (!stream_)
    {
        throw std::runtime_error("No memory for the screen of LIGGGHTS.");
    }
    // A line reaches write() when it ends, so before LIGGGHTS can abort after printing it.
    std::setvbuf(stream_, nullptr, _IOLBF, BUFSIZ);
    if (!path_.empty())
    {
        copy_ = std::fopen(path_.c_str(), "w");
    }
}

ScreenStream::~ScreenStream()
{
    std::fclose(stream_);
    if (copy_)
    {
        std::fclose(copy_);
    }
}

void ScreenStream::announceEnd() const
{
    if (firstRank_ && !sawError_)
    {
        std::fprintf(stderr, "\nLIGGGHTS ended the program while %s.\n", task_.c_str());
        std::fflush(stderr);
    }
}

ssize_t ScreenStream::write(void* self, const char* text, std::size_t size)
{
    ScreenStream& screen = *static_cast<ScreenStream*>(self);
    for (std::size_t i = 0; i < size; ++i)
    {
        screen.line_ += text[i];
        if (text[i] == '\n')
        {
            screen.takeLine();
        }
    }
    return static_cast<ssize_t>(size);
}

void ScreenStream::takeLine()
{
    if (copy_)
    {
        std::fputs(line_.c_str(), copy_);
        // Followed by users while it grows, and lost in an abort if it stayed in the buffer.
        std::fflush(copy_);
    }
    if (!sawError_ && line_.compare(0, 5, "ERROR") == 0)
    {
        sawError_ = true;
        std::fprintf(stderr, "\nLIGGGHTS stopped while %s:\n", task_.c_str());
        if (!lastLine_.empty())
        {
            std::fprintf(stderr, "    its last line before: %s", lastLine_.c_str());
        }
        if (!path_.empty())
        {
            std::fprintf(stderr, "    all it printed: %s\n", path_.c_str());
        }
    }
    if (sawError_)
    {
        passOn();
    }
    if (line_.find_first_not_of(" \t\n") != std::string::npos)
    {
        lastLine_ = line_;
    }
    line_.clear();
}

// LIGGGHTS prints an error twice, the second time with rubbish for the text, but the same place in
// its code at the end: "(./src/file.cpp:line)".
void ScreenStream::passOn()
{
    const std::size_t bracket = line_.rfind("(./src/");
    const std::string place = bracket == std::string::npos ? "" : line_.substr(bracket);
    if (place.empty() || place != errorPlace_)
    {
        std::fputs(line_.c_str(), stderr);
        std::fflush(stderr);
    }
    errorPlace_ = place.empty() ? errorPlace_ : place;
}

LiggghtsAtWork::LiggghtsAtWork(ScreenStream& screen, const std::string& task)
    : outer_(atWork)
{
    static const bool registered = listenForTheEnd();
    static_cast<void>(registered);

    screen.setTask(task);
    atWork = &screen;
    std::feholdexcept(&floatingPoint_);
}

LiggghtsAtWork::~LiggghtsAtWork()
{
    std::fesetenv(&floatingPoint_);
    atWork = outer_;
}

} // namespace interstice::dem
