"""Export of pictures and turntables."""
