// By what a picture is multiplied before it is shown or compared as shown: scenes may be lit in
// physical units, by tens of thousands of lux.
#pragma once

#include "reports/picture.h"

namespace sb {

/// The factor that takes the log-average luminance of what is not black (Reinhard, Stark, Shirley,
/// Ferwerda 2002, section 3.1) to middle grey, 0.18, in whole stops, so that techniques that differ
/// by their shadows get one factor. 1 where that is within three stops: such scenes are lit for
/// display already. 1 for a picture without light.
float automaticExposure(const report::Picture& picture);

/// The picture times `exposure`; alpha stays.
report::Picture exposed(const report::Picture& picture, float exposure);

}  // namespace sb
