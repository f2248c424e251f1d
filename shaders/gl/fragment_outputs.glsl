// The outputs of a fragment shader. Those of the compatibility profile are not in every core profile.

#if !defined(OSGLEGO_CORE_PROFILE)
#define fragmentData gl_FragData
#define fragmentColor gl_FragColor
#elif defined(NUM_OUTPUTS)
layout(location = 0) out vec4 fragmentData[NUM_OUTPUTS];
#else
layout(location = 0) out vec4 fragmentColor;
#endif
