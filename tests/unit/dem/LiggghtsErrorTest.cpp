// SPDX-License-Identifier: GPL-3.0-or-later
// LIGGGHTS ends the program on an error, so each case is a program of its own.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace
{

struct Outcome
{
    int exitCode = 0;
    std::string stderrText;
};

constexpr int timedOut = 124; // of timeout(1)

Outcome runProbe(const std::string& way, int ranks)
{
    const std::string line = "timeout 60 " INTERSTICE_MPIEXEC " --oversubscribe -n "
        + std::to_string(ranks) + " " INTERSTICE_PROBE " '" + way + "' 2>&1 >/dev/null";
    Outcome outcome;
    std::FILE* pipe = popen(line.c_str(), "r");
    std::array<char, 256> text{};
    while (std::fgets(text.data(), text.size(), pipe))
    {
        outcome.stderrText += text.data();
    }
    outcome.exitCode = WEXITSTATUS(pclose(pipe));
    return outcome;
}

void expectEndWith(const std::string& message, const Outcome& outcome)
{
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.exitCode, timedOut);
    EXPECT_NE(outcome.stderrText.find(message), std::string::npos) << outcome.stderrText;
}

} // namespace

TEST(LiggghtsError, ThatAllRanksFindReachesTheTerminalWithItsScriptAndLine)
{
    for (const int ranks : {1, 2, 4})
    {
        const Outcome outcome = runProbe("unknown fix", ranks);
        expectEndWith("nve/sfere", outcome);
        expectEndWith("ERROR: Invalid fix style", outcome);
        expectEndWith("wrong.in", outcome);
        expectEndWith("screen.liggghts", outcome);
    }
}

TEST(LiggghtsError, ThatOneRankFindsReachesTheTerminal)
{
    for (const int ranks : {1, 2, 4})
    {
        const std::string prefix = "ERROR on proc " + std::to_string(ranks - 1) + ": ";
        expectEndWith(prefix + "Fix nve/sphere requires", runProbe("one rank", ranks));
    }
}

TEST(LiggghtsError, IsNamedEvenWhenLiggghtsQuitsInSilence)
{
    expectEndWith("LIGGGHTS ended the program while executing the command: quit",
                  runProbe("quit", 2));
}

TEST(LiggghtsError, IsNotWaitedForWhenAScriptIsMissing)
{
    expectEndWith("nowhere.in", runProbe("missing script", 2));
}

// OpenFOAM traps floating point errors in the whole program; LIGGGHTS is not built for that.
TEST(LiggghtsError, IsNotMadeOfFloatingPointTraps)
{
    const Outcome outcome = runProbe("traps", 2);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.stderrText;
    EXPECT_NE(outcome.stderrText.find("traps still on"), std::string::npos);
}
