// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace interstice
{

/// Something that a scene may call for, and the number by which it does.
struct Effect
{
    enum class Wish
    {
        automatic, ///< by the number
        on,
        off
    };

    std::string key; ///< in the case
    std::string number; ///< what decides, in words
    double limit = 0; ///< up to it the effect may be left out
    Wish wish = Wish::automatic;

    std::optional<double> largest = {}; ///< of the number, so far; none before anybody has looked
    bool on = false;
    std::string how = {}; ///< if there is more to say than on or off
    std::string by = {}; ///< who decided, if neither the user nor the number
    double since = 0; ///< time from which on the number asked for it [s]
    double seconds = 0; ///< of wall time that it cost on this rank so far

    bool askedFor() const { return largest && *largest > limit; }
};

/// The effects of a run: which are simulated, by which number, and who decided. All member functions
/// are local; to decide alike, all ranks must give the same values.
class EffectTable
{
public:
    /// The word of a case, on, off or auto. Throws InputError for another one, which names `where`
    /// (file and key).
    static Effect::Wish wish(const std::string& word, const std::string& where);

    /// Adds an effect, which is on if it was before or if that is the wish. Returns its place in the table.
    std::size_t add(const Effect& effect);

    bool on(std::size_t place) const { return effects_[place].on; }

    /// The number as it is at a time [s]. Returns what the user is to be told, once: that the effect
    /// is on from now, or that one which is not wished, or not everywhere, is called for. Else empty.
    std::string meet(std::size_t place, double value, double time);

    /// Books wall time [s].
    void spend(std::size_t place, double seconds) { effects_[place].seconds += seconds; }

    /// Its place. There must be one.
    std::size_t place(const std::string& key) const;

    /// Books the time from its construction to its end.
    class Timed
    {
    public:
        Timed(EffectTable& table, std::size_t place) : table_(table), place_(place) {}
        ~Timed()
        {
            const std::chrono::duration<double> spent = Clock::now() - start_;
            table_.spend(place_, spent.count());
        }
        Timed(const Timed&) = delete;
        Timed& operator=(const Timed&) = delete;

    private:
        using Clock = std::chrono::steady_clock;

        EffectTable& table_;
        std::size_t place_;
        Clock::time_point start_ = Clock::now();
    };

    const std::vector<Effect>& effects() const { return effects_; }

    /// Who decided: "number", "user", or what the effect names.
    static std::string decidedBy(const Effect& effect);

    /// A table for the screen, with a line an effect; with shares of a wall time [s], if there is one.
    std::string text(double wall = 0) const;

private:
    std::vector<Effect> effects_;
};

} // namespace interstice
