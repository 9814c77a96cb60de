/* The iteration that both controllers share; it lasts TIME_STEP ms. */
#define TIME_STEP 32

void timing_reset(void);
void timing_iteration(void);
void timing_die(void);
