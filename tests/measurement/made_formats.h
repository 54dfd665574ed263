#pragma once
#include <string>
#include <vector>

namespace lrcs {

// One small valid file of each format that is text.

inline const std::string made_csv =
    "# wavelength: 1.06 um\n# azimuth_of_specular: 180\n# value: brdf_cosine\n"
    "theta_i_deg,theta_r_deg,phi_deg,f_r_per_sr,weight\n10,20,0,0.1,1\n10,-20,0,0.2,2\n30,-30,10,0.3,1\n";

inline const std::string made_alta =
    "#SAMPLE \"made\"\n#DIM 3 1\n#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n#VS 0\n"
    "0.25 0.25 0 11.5\n0.25 -0.3 0.1 0.4\n0.5 0 0.5 0.2\n";

inline const std::string made_zemax =
    "# red laser (650 nm)\nSource Measured\nSymmetry PlaneSymmetrical\nSpectralContent Monochrome\nScatterType BRDF\n"
    "SampleRotation 1\n0\nAngleOfIncidence 2\n10 30\nScatterAzimuth 3\n0 90 180\nScatterRadial 3\n0 20 70\n\n"
    "Monochrome\nDataBegin\nTIS 0.5\n0.9 0.8 0.7\n0.9 0.6 0.5\n0.9 0.4 0.3\nTIS 0.6\n1.9 1.8 1.7\n1.9 1.6 1.5\n"
    "1.9 1.4 0\nDataEnd\n";

inline const std::string made_fred =
    "type bsdf_data\nformat angles=deg bsdf=value scale=2\n10 0\n0 0 0.1\n10 0 0.9\n10 90 0.2\n30 0\n30 0 0.8\n90 0 "
    "1\n";

inline const std::string made_lumos =
    "# measured at a wavelength lambda = 532 nm\n#\n# phi_i theta_i phi_o theta_o brdf\n"
    "75.00 -180.00 -90.00 0.00 1e-4\n75.00 -180.00 -75.00 0.00 2e-4\n75 -180 75.00 0.00 3.5\n5 -180 5 0 1.5\n";

inline const std::string made_nist =
    "lambda,thetai,phi,thetar,phir,f_r11,f_r12/f_r11\r\n1.064,-0.001,0,45,-90,0.31,0.1\r\n"
    "0.532,-30,0,30,0,0.33,0.1\r\n0.532,-30,0,30,180,0.30,0.1\r\n";

inline const std::string made_factors =
    "BRF Values\nSpectralon 7\nsrc_z\tsrc_a\tview_z\tview_a\t1059.04nm\t385.65nm\n"
    "  0.000\t0.000\t45.000\t180.000\t1.02\t0.99\n 45.000\t0.000\t45.000\t180.000\t1.09\t1.05\n";

inline std::vector<std::string> made_formats() {
  return {made_csv, made_alta, made_zemax, made_fred, made_lumos, made_nist, made_factors};
}

}  // namespace lrcs
