// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cfenv>
#include <cstdio>
#include <string>

namespace interstice::dem
{

/// The stream that LIGGGHTS prints to, on every rank.
///
/// LIGGGHTS reports an error by printing it and ending the program at once, on ranks that may
/// have no screen of their own, sometimes without flushing. This stream writes the first rank's
/// lines to a file, and from the first line that begins with "ERROR" on copies everything to
/// stderr before the print returns. Every rank must have one: parts of LIGGGHTS print without
/// asking whether there is a screen.
class ScreenStream
{
public:
    /// Local. `path` is the file of what LIGGGHTS prints; the first rank keeps it, unless empty.
    ScreenStream(bool firstRank, const std::string& path);
    ~ScreenStream();

    ScreenStream(const ScreenStream&) = delete;
    ScreenStream& operator=(const ScreenStream&) = delete;

    std::FILE* file() const
    {
        return stream_;
    }

    /// What LIGGGHTS is doing, for the message: "running script fill.in".
    void setTask(const std::string& task)
    {
        task_ = task;
    }

    /// Says on stderr that LIGGGHTS ended the program, unless its own message is there; once,
    /// by the first rank.
    void announceEnd() const;

private:
    static ssize_t write(void* self, const char* text, std::size_t size);
    void takeLine();
    void passOn();

    std::FILE* stream_ = nullptr;
    std::FILE* copy_ = nullptr;
    bool firstRank_;
    std::string path_;
    std::string task_;
    std::string line_;     ///< being put together
    std::string lastLine_; ///< the one before it that was not empty
    bool sawError_ = false;
    std::string errorPlace_; ///< the place in LIGGGHTS' code that the error names
};

/// Marks, while it lives, that LIGGGHTS is at work, and on what.
///
/// Should LIGGGHTS end the program meanwhile without a word (its `quit` command does), the end
/// is announced on stderr. Floating point traps are off: LIGGGHTS is built to run without them,
/// and OpenFOAM turns them on.
class LiggghtsAtWork
{
public:
    LiggghtsAtWork(ScreenStream& screen, const std::string& task);
    ~LiggghtsAtWork();

    LiggghtsAtWork(const LiggghtsAtWork&) = delete;
    LiggghtsAtWork& operator=(const LiggghtsAtWork&) = delete;

private:
    std::fenv_t floatingPoint_;
    ScreenStream* outer_;
};

} // namespace interstice::dem
