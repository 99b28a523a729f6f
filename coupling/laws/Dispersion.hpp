// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace interstice
{

/// How the fluctuations of turbulent air are met by a grain, in a velocity s w(t) beside the mean, with s = sqrt(2 k/3)
/// and one w a direction:
///
///     dw = -w/T dt + ds/dx dt/(1 + t_p/T) + sqrt(2/T) dW
///
/// The second part keeps grains that follow the air where they are evenly spread, however unevenly k is: D.J. Thomson,
/// J. Fluid Mech. 180 (1987) 529-556; with t_p, the grain's response time, T.L. Bocksell & E. Loth, Int. J. Multiphase
/// Flow 32 (2006) 1234-1254.

/// Time over which the air's fluctuation is remembered along its own path, k/e/(1/2 + 3 C_0/4) with C_0 = 2.1 [s]: J.-P.
/// Minier & E. Peirano, Phys. Rep. 352 (2001) 1-214. Zero without turbulence.
///
/// @param energy      k [m2/s2]
/// @param dissipation e [m2/s3]
double lagrangianTime(double energy, double dissipation);

/// The same along the path of a grain that slips through the eddies, T_L/sqrt(1 + (slip/s)^2): G.T. Csanady, J. Atmos.
/// Sci. 20 (1963) 201-208, for the direction of the slip, with eddies of the length s T_L; taken for all directions here.
double seenTime(double lagrangianTime, double slip, double rms);

/// A step of the equation above for fixed s, T and drift, exact whatever its length: w at its end and the mean of w over
/// it have the joint distribution that the equation gives them.
class LangevinStep
{
public:
    /// @param ratio dt/T, at least 0; infinite is allowed
    explicit LangevinStep(double ratio);

    struct Result
    {
        double end; ///< w at the end of the step
        double mean; ///< of w over the step
    };

    /// @param w     at the start of the step
    /// @param drift T ds/dx/(1 + t_p/T)
    /// @param first, second independent, of the standard normal distribution
    Result operator()(double w, double drift, double first, double second) const;

private:
    double kept_; // exp(-dt/T)
    double keptMean_; // of that over the step
    double end_; // weight of `first` in the end
    double mean_; // and in the mean
    double rest_; // weight of `second` in the mean
};

} // namespace interstice
