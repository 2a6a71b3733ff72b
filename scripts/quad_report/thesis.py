"""Numbers the thesis prints that the figures show beside ours. The table's numbers come with the run (table.json)."""

ALPHA = (0.04, 0.94, 1.76, -2.62)     # [N] section 2.4.2
GAMMA_E = 3.29                        # [N] section 2.4.2
CROSSOVER = 0.218                     # [Hz] f_c, section 2.4.1
FEED_FORWARD = 6.1221                 # [N] m_hat_0 g, section 2.4.1
WEIGHT = 7.1541                       # [N] m g, Table 2.1
WALLCLOCK_PERIOD = 0.15               # [s] dT_des of Figs 1.6 and 1.7
WALLCLOCK_MEAN = 0.14992              # [s] mean(dT), section 1.2.4
GAMMA_W_SIM = 10.62                   # section 3.2.1
GAMMA_W_EXP = {"targeted": 17.87}     # Eq. (3.1)
LAMBDA_D_BD = {"targeted": 212.8}     # section 3.2.2
ESTIMATE = {"targeted": (0.09989, 0.002517, 0.1363),    # A12, B1, B2: section 2.4.4
            "random": (0.10003, 0.01219, 0.0615)}       # section 3.3.3
