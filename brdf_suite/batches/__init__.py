"""Batches: thousands of paints measured, fitted, rendered or exported, on all cores or on a cluster."""
